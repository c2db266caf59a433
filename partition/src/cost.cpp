#include "weavefront/partition/cost.hpp"

#include <cmath>

namespace weavefront::partition {

namespace {

// Measured on one core with AVX-512 in the 267 m/s example (8 plies; a mean over 200 us and over h = 1 and 2 mm); only their ratio matters.
constexpr double element_cost = 94;   // ns a step
constexpr double contact_cost = 400;  // ns a step of an element whose points touch the projectile or a neighbouring ply
constexpr double contact_reach = 16;  // radius of the region in contact, mean over time, over that of the projectile

}  // namespace

std::vector<std::int32_t> column_costs(const mesh::Panel& panel, const scene::Scene& scene) {
    const double radius = scene.projectile ? contact_reach * scene.projectile->diameter / 2 : 0;
    const bool ply_contact = scene.contact.plies && panel.plies.size() > 1;
    std::vector<std::int32_t> costs;
    costs.reserve(static_cast<std::size_t>(panel.columns()));
    const auto plies = static_cast<double>(panel.plies.size());
    for (std::int64_t column = 0; column < panel.columns(); ++column) {
        const auto corners = panel.footprint(column);
        const Vec3 centre = (panel.position(0, corners[0]) + panel.position(0, corners[2])) / 2;
        double cost = plies * element_cost;
        if (scene.projectile) {
            const double distance = std::hypot(centre.x() - scene.projectile->position[0], centre.y() - scene.projectile->position[1]);
            if (distance < radius) cost += (ply_contact ? plies : 1) * contact_cost;
        }
        costs.push_back(static_cast<std::int32_t>(cost));
    }
    return costs;
}

}  // namespace weavefront::partition
