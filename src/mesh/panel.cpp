#include "weavefront/mesh/panel.hpp"

#include <stdexcept>

#include "weavefront/mesh/graded_line.hpp"

namespace weavefront::mesh {

namespace {

constexpr std::uint8_t hold_x = 1, hold_y = 2, hold_z = 4;

std::uint8_t held_by(scene::Edge edge) {
    switch (edge) {
        case scene::Edge::fixed:
            return hold_x | hold_y | hold_z;
        case scene::Edge::sliding:
        case scene::Edge::clamp:
            return hold_z;
        case scene::Edge::frame:
        case scene::Edge::free:
            return 0;
    }
    return 0;
}

}  // namespace

double Panel::smallest_edge() const {
    double smallest = x.back() - x.front();
    for (const auto* line : {&x, &y})
        for (std::size_t i = 1; i < line->size(); ++i)
            smallest = std::min(smallest, (*line)[i] - (*line)[i - 1]);
    return smallest;
}

std::array<std::int64_t, 4> Panel::footprint(std::int64_t column) const {
    const auto i = column % columns_x(), j = column / columns_x(), stride = columns_x() + 1;
    const auto first = j * stride + i;
    return {first, first + 1, first + stride + 1, first + stride};
}

Vec3 Panel::position(std::int32_t ply, std::int64_t footprint_node) const {
    const auto stride = columns_x() + 1;
    return {x[static_cast<std::size_t>(footprint_node % stride)],
            y[static_cast<std::size_t>(footprint_node / stride)], plies[static_cast<std::size_t>(ply)].z};
}

std::uint8_t Panel::supports(std::int64_t footprint_node) const {
    const auto stride = columns_x() + 1;
    const auto i = footprint_node % stride, j = footprint_node / stride;
    std::uint8_t held = 0;
    if (i == 0) held |= symmetry[0] ? hold_x : held_by(edges[0]);
    if (i == columns_x()) held |= held_by(edges[0]);
    if (j == 0) held |= symmetry[1] ? hold_y : held_by(edges[1]);
    if (j == columns_y()) held |= held_by(edges[1]);
    for (std::size_t axis = 0; axis < 2; ++axis)
        if (frame && frame->is_beyond(axis, x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)]))
            held |= held_by(edges[axis]);
    return held;
}

std::optional<std::size_t> Panel::clamp_of(std::int64_t footprint_node) const {
    if (!frame) return std::nullopt;
    const Vec3 at = position(0, footprint_node);
    for (std::size_t axis = 0; axis < 2; ++axis)
        if (edges[axis] == scene::Edge::clamp && frame->is_beyond(axis, at.x(), at.y())) return axis;
    return std::nullopt;
}

Panel make_panel(const scene::Scene& scene) {
    if (!scene.target) throw std::invalid_argument("a panel needs a scene with a target");
    const auto& target = *scene.target;
    Panel panel;
    const auto line = [&](std::size_t axis) {
        const double half = target.size[axis] / 2;
        const double fine = target.symmetry[axis] || scene.projectiles.empty()
                                ? 0.0
                                : scene.projectiles.front().position[axis];
        return graded_line(target.symmetry[axis] ? 0.0 : -half, half, fine, target.mesh);
    };
    panel.x = line(0);
    panel.y = line(1);
    panel.plies = target.plies;
    panel.symmetry = target.symmetry;
    panel.edges = target.edges;
    panel.frame = target.frame;
    return panel;
}

}  // namespace weavefront::mesh
