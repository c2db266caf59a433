#include "doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::app {

namespace {

// Crimp makes yarns longer than the cell and coatings add mass; beyond this factor a number or a unit is wrong.
constexpr double most_apart = 1.3;

std::vector<std::string> doubts(const scene::Fabric& fabric) {
    std::vector<std::string> found;
    const auto& yarn = fabric.yarn;
    const double of_yarns = 2 * yarn.area * fabric.density / yarn.span, ratio = fabric.areal_density / of_yarns;
    if (fabric.density > 0 && std::max(ratio, 1 / ratio) > most_apart)
        found.push_back(
            fmt::format("fabric {}: yarns of {:.4g} mm2 every {:.4g} mm in two directions weigh {:.4g} g/m2 at {:.4g} kg/m3, but "
                        "the areal density is {:.4g} g/m2",
                        fabric.name, yarn.area * 1e6, yarn.span * 1e3, of_yarns * 1e3, fabric.density, fabric.areal_density * 1e3));
    if (fabric.thickness > yarn.span)
        found.push_back(fmt::format("fabric {}: its yarns rise and fall by {:.4g} mm every {:.4g} mm", fabric.name, fabric.thickness * 1e3,
                                    yarn.span * 1e3));
    return found;
}

/// Of a projectile that does not reach the target. Its default position touches the first ply.
std::vector<std::string> doubts_of_way(const scene::Projectile& projectile, const scene::Fabric& first, double end) {
    const double gap = -first.contact_thickness / 2 - projectile.position[2], speed = projectile.velocity[2];
    if (gap / speed < end) return {};
    return {fmt::format("the projectile needs {:.4g} us to the first ply, the run ends at {:.4g} us", gap / speed * 1e6, end * 1e6)};
}

std::vector<std::string> doubts(const scene::Frame& frame, double across) {
    std::vector<std::string> found;
    for (std::size_t d = 0; d < 2; ++d) {
        const auto& half = frame.half_opening[d];
        if (half && 2 * *half < across)
            found.push_back(fmt::format("the frame's opening is {:.4g} mm along {}, less than the {:.4g} mm of the projectile", *half * 2e3,
                                        d == 0 ? "x" : "y", across * 1e3));
    }
    return found;
}

}  // namespace

std::vector<std::string> doubts(const scene::Scene& scene) {
    std::vector<std::string> found;
    for (const auto& fabric : scene.fabrics) std::ranges::move(doubts(fabric), std::back_inserter(found));
    if (!scene.projectile || !scene.target) return found;
    const double across = scene.projectile->diameter, size = std::max(scene.target->size[0], scene.target->size[1]);
    if (across > size) found.push_back(fmt::format("the projectile is {:.4g} mm across, the target {:.4g} mm", across * 1e3, size * 1e3));
    const auto& first = scene.fabrics[static_cast<std::size_t>(scene.target->plies.front().fabric)];
    std::ranges::move(doubts_of_way(*scene.projectile, first, scene.time.end), std::back_inserter(found));
    if (scene.target->frame) std::ranges::move(doubts(*scene.target->frame, across), std::back_inserter(found));
    return found;
}

std::vector<std::string> doubts(const scene::Scene& scene, double time_step) {
    if (!scene.projectile || !scene.contact.projectile) return {};
    double thinnest = std::numeric_limits<double>::max();
    for (const auto& ply : scene.target->plies)
        thinnest = std::min(thinnest, scene.fabrics[static_cast<std::size_t>(ply.fabric)].contact_thickness);
    const auto& v = scene.projectile->velocity;
    const double way = std::hypot(v[0], v[1], v[2]) * time_step;
    if (way <= thinnest) return {};
    return {fmt::format("the projectile goes {:.4g} mm in a step, more than the {:.4g} mm that a ply is thick: it will pass through unseen",
                        way * 1e3, thinnest * 1e3)};
}

}  // namespace weavefront::app
