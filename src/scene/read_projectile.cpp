#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "attitude.hpp"
#include "parts.hpp"
#include "stl.hpp"

namespace weavefront::scene {
namespace {

constexpr double farthest = 1000;  // m: where no shot begins

// Every rank moves all of them, and each has a group of columns in history.csv.
constexpr std::size_t most_projectiles = 100;

// The shot must start in front of the target, hit it, and lie in the planes of symmetry.
void check_shot(Section& section, const Projectile& projectile, const Target& target, double foremost) {
    const double rounding = 1e-9;
    const MessageUnit z_unit = section.unit_of("position", length, 2);
    section.refuse_item_if(
        projectile.position[2] > foremost + rounding * std::abs(foremost), "position", 2,
        fmt::format("at most {}: the nose starts in front of the first ply", at_most_text(foremost, z_unit)));
    section.refuse_item_if(projectile.velocity[2] <= 0, "velocity", 2, "more than 0: towards the target");
    for (const auto& [name, axis] : axis_names) {
        const double half = target.size[axis] / 2;
        const MessageUnit unit = section.unit_of("position", length, axis);
        section.refuse_item_if(std::abs(projectile.position[axis]) > half, "position", axis,
                               fmt::format("from -{0} to {0}: over the target", at_most_text(half, unit)));
        if (!target.symmetry[axis]) continue;
        section.refuse_if(
            projectile.shape == Shape::mesh && !is_symmetric(projectile.triangles, axis), "shape",
            fmt::format("one that is its own mirror image about {0} = 0 with symmetry {0}", name));
        section.refuse_item_if(std::abs(projectile.position[axis]) > 0, "position", axis,
                               fmt::format("0 with symmetry {}", name));
        section.refuse_item_if(std::abs(projectile.velocity[axis]) > 0, "velocity", axis,
                               fmt::format("0 with symmetry {}", name));
    }
}

/// Distance by which a hollow nose reaches ahead of its foremost point on the axis, m.
double ahead_of_nose(const Projectile& projectile) {
    double ahead = 0;
    for (const auto& point : projectile.profile) ahead = std::max(ahead, point[1]);
    for (const auto& point : projectile.triangles.points) ahead = std::max(ahead, point[2]);
    return ahead;
}

/// How far the projectile reaches ahead of its reference point along z, m. A bound: that of the cylinder
/// around it.
double reach_ahead(const Projectile& projectile) {
    const auto across_x = turned_axis(projectile.attitude, 0)[2],
               across_y = turned_axis(projectile.attitude, 1)[2],
               along = turned_axis(projectile.attitude, 2)[2];
    const double radius = projectile.diameter / 2, ahead = ahead_of_nose(projectile);
    if (projectile.shape == Shape::sphere) return radius * (1 - along);
    return radius * std::sqrt(across_x * across_x + across_y * across_y) +
           std::max(along * ahead, -along * (projectile.length - ahead));
}

Projectile read_projectile(Section& section, std::span<const Fabric> fabrics, const Target* target) {
    Projectile projectile;
    read_shape(section, projectile);
    const bool hits_fabric = target != nullptr && !target->plies.empty() && target->plies[0].fabric >= 0;
    const double surface =
        hits_fabric ? -fabrics[static_cast<std::size_t>(target->plies[0].fabric)].contact_thickness / 2 : 0;
    read_attitude(section, projectile, target);
    const double foremost = surface - reach_ahead(projectile);
    projectile.position =
        section.vector<3>("position", length, any_value, std::array<double, 3>{0, 0, foremost});
    projectile.velocity = section.vector<3>("velocity", speed, any_value);
    projectile.delay = section.quantity("delay", duration, non_negative, 0);
    section.refuse_if(projectile.delay * projectile.speed() > farthest, "delay",
                      fmt::format("one with which it starts at most {} m behind its position", farthest));
    if (hits_fabric) check_shot(section, projectile, *target, foremost);
    return projectile;
}

}  // namespace

std::vector<Projectile> read_projectiles(Section& scene, std::span<const Fabric> fabrics,
                                         const Target* target) {
    const auto read = [&](Section& section) { return read_projectile(section, fabrics, target); };
    const bool has_single = scene.has("projectile");
    if (!scene.has("projectiles")) {
        const auto single = scene.optional("projectile", read);
        return single ? std::vector{*single} : std::vector<Projectile>();
    }
    constexpr std::string_view allowed = "a list of maps, each as that of projectile";
    scene.refuse_if(has_single, "projectiles", "none beside projectile");
    scene.refuse_if(!scene.has_list("projectiles"), "projectiles", allowed);
    if (!scene.has_list("projectiles")) return {};
    const auto count = scene.raw("projectiles")->value.items.size();
    scene.require_at_most("projectiles", count, most_projectiles, "projectiles");
    scene.refuse_if(count == 0, "projectiles", allowed);
    return scene.list("projectiles", read);
}

}  // namespace weavefront::scene
