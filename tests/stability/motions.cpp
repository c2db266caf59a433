#include "motions.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace weavefront::stability {

namespace {

/// Moves every node along z by up to `size`, each by its own amount.
void roughen(solver::Nodes& nodes, double size) {
    for (std::size_t n = 0; n < nodes.x.size(); ++n)
        if (!(nodes.supports[n] & 4U))
            nodes.x[n].z() += size * std::sin(12.9898 * static_cast<double>(nodes.ids[n] % 1009) + 1);
}

}  // namespace

Prepare stretching(double rate_x, double rate_y, double roughness) {
    return [=](solver::Simulation& simulation) {
        auto& nodes = simulation.model().nodes;
        for (std::size_t n = 0; n < nodes.x.size(); ++n)
            nodes.v[n] = Vec3(rate_x * nodes.x[n].x(), rate_y * nodes.x[n].y(), 0);
        roughen(nodes, roughness);
    };
}

Prepare crumpling(double speed, double length, double roughness) {
    return [=](solver::Simulation& simulation) {
        auto& nodes = simulation.model().nodes;
        for (std::size_t n = 0; n < nodes.x.size(); ++n)
            if (!(nodes.supports[n] & 1U))
                nodes.v[n] = Vec3(-speed * std::sin(2 * std::numbers::pi * nodes.x[n].x() / length), 0, 0);
        roughen(nodes, roughness);
    };
}

Prepare broken_yarn() {
    return [](solver::Simulation& simulation) {
        auto& model = simulation.model();
        auto& group = *model.groups.front();
        // One step of a stretch along the fill, well above any breaking strain and the slack of the crimp,
        // breaks the fill of a pack; one step back.
        auto stretched = model.nodes.x;
        for (auto& x : stretched) x.x() *= 1.1;
        shell::AlignedVector<double> forces(shell::forces_per_pack);
        shell::Events events;
        const auto row = static_cast<std::int32_t>(simulation.panel().columns_x()) *
                         static_cast<std::int32_t>(simulation.panel().columns_y() / 2);
        const std::int32_t pack = row / shell::pack_width;
        group.set_time_step(simulation.time_step());
        group.advance(pack, 1, stretched, forces, events);
        group.advance(pack, 1, model.nodes.x, forces, events);
        if (events.broken_fill != shell::pack_width || events.broken_warp != 0)
            throw std::logic_error("the yarn did not break alone");
    };
}

}  // namespace weavefront::stability
