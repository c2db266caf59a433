#include "weavefront/solver/projectile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "warnings/subjects.hpp"
#include "weavefront/body/shape.hpp"

namespace weavefront::app {

namespace {

// Fragments and bullets: polymers from 900 kg/m3, lead 11340, tungsten 19300, the densest element osmium
// 22590. Hollow ones are lighter, by a half at the most.
constexpr double least_density = 450, most_density = 22600;

// A coin is 0.1 of its width long; rods that pierce armour are up to about 40 times as long as wide.
constexpr double least_length = 0.05, most_length = 40;

// The axis of a projectile stays along z: at this angle to its way one side of a rim as wide as the fabric is
// thick arrives first.
constexpr double most_yaw = std::numbers::pi / 180;

void warn_of_shape(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    const auto& units = shot.scene.units;
    const double volume = body::make_shape(projectile)->mass_properties().volume;
    const double d = projectile.diameter, density = projectile.mass / volume, ratio = projectile.length / d;
    if (projectile.shape == scene::Shape::cylinder && (ratio < least_length || ratio > most_length))
        found.push_back(fmt::format(
            "the projectile is {} long and {} wide: by its mass of {}, unless its length is given",
            text_of(projectile.length, units.length), text_of(d, units.length),
            text_of(projectile.mass, units.mass)));
    else if (density < least_density || density > most_density)
        found.push_back(fmt::format("the projectile weighs {} at its size ({}), materials {} to {}",
                                    text_of(density, units.density), text_of(projectile.mass, units.mass),
                                    text_of(least_density, units.density, 6),
                                    text_of(most_density, units.density, 6)));
}

void warn_of_yaw(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    const auto& v = projectile.velocity;
    const double angle = std::atan2(std::hypot(v[0], v[1]), v[2]);
    if (projectile.shape != scene::Shape::sphere && angle > most_yaw)
        found.push_back(
            fmt::format("the {} flies at {:.3g} deg to its axis, which stays along z: velocity {}, {}, {}",
                        scene::shape_name(projectile.shape), angle * 180 / std::numbers::pi,
                        text_of(v[0], shot.scene.units.speed), text_of(v[1], shot.scene.units.speed),
                        text_of(v[2], shot.scene.units.speed)));
}

/// Of a projectile that does not reach the target. Its default position touches the first ply.
void warn_of_way(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    const double gap = -shot.struck().contact_thickness / 2 - projectile.position[2],
                 time = projectile.delay + gap / projectile.velocity[2];
    if (time >= shot.scene.time.end)
        found.push_back(fmt::format("the projectile needs {} to the first ply, the run ends at {}",
                                    text_of(time, shot.scene.units.time),
                                    text_of(shot.scene.time.end, shot.scene.units.time)));
}

/// Wider than the target, or over one of its edges. A strip that is hit across its whole width has it over
/// both, which is meant.
void warn_of_place(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    const auto length = [&](double value) { return text_of(value, shot.scene.units.length); };
    const auto& size = shot.scene.target->size;
    const double across = projectile.diameter;
    if (across > std::ranges::max(size)) {
        found.push_back(fmt::format("the projectile is {} across, the target {}", length(across),
                                    length(std::ranges::max(size))));
        return;
    }
    const auto place = place_at(projectile, -shot.struck().contact_thickness / 2);
    for (std::size_t d = 0; d < 2; ++d) {
        const double half = size[d] / 2, beyond = std::abs(place[d]) + across / 2 - half;
        if (beyond > 0 && std::abs(place[d]) - across / 2 > -half)
            found.push_back(
                fmt::format("the projectile meets the target at {} = {}, its side {} beyond the edge",
                            d == 0 ? "x" : "y", length(place[d]), length(beyond)));
    }
}

void warn_of_bars(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    const auto length = [&](double value) { return text_of(value, shot.scene.units.length); };
    const auto& frame = *shot.scene.target->frame;
    const auto& last = shot.panel.plies.back();
    const auto place = place_at(projectile, last.z + shot.fabric_of(last).contact_thickness / 2);
    for (std::size_t d = 0; d < 2; ++d) {
        const auto& half = frame.half_opening[d];
        if (!half || 2 * *half < projectile.diameter) continue;  // said of the opening
        if (std::abs(place[d]) + projectile.diameter / 2 > *half)
            found.push_back(fmt::format(
                "on its way the projectile meets a bar of the frame: it is {} wide and would pass "
                "at {} = {}, the opening ends at {}",
                length(projectile.diameter), d == 0 ? "x" : "y", length(place[d]), length(*half)));
    }
    if (!frame.radius || 2 * *frame.radius < projectile.diameter) return;
    const double from_axis = std::sqrt(place[0] * place[0] + place[1] * place[1]);
    if (from_axis + projectile.diameter / 2 > *frame.radius)
        found.push_back(fmt::format(
            "on its way the projectile meets the ring of the frame: it is {} wide and would pass {} from its "
            "axis, the opening ends at {}",
            length(projectile.diameter), length(from_axis), length(*frame.radius)));
}

}  // namespace

void warn_of_overlaps(const scene::Scene& scene, Phrases& found) {
    if (scene.projectiles.size() < 2) return;
    std::vector<solver::Projectile> projectiles;
    for (const auto& projectile : scene.projectiles)
        projectiles.push_back(solver::make_projectile(projectile));
    solver::ProjectileOverlap overlap;
    overlap.look(projectiles, 0);
    if (overlap.depth > 0)
        found.push_back(fmt::format(
            "projectiles {} and {} start {} inside each other, and contact between projectiles is not "
            "computed: give them other positions, or a delay",
            overlap.first + 1, overlap.second + 1, text_of(overlap.depth, scene.units.length)));
}

void warn_of_projectile(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    warn_of_shape(shot, projectile, found);
    warn_of_yaw(shot, projectile, found);
    warn_of_way(shot, projectile, found);
    warn_of_place(shot, projectile, found);
    if (shot.scene.target->frame) warn_of_bars(shot, projectile, found);
    if (shot.scene.contact.projectile) warn_of_projectile_contact(shot, projectile, found);
}

}  // namespace weavefront::app
