#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "warnings/subjects.hpp"

namespace weavefront::app {

namespace {

// Fewer elements or contact points across the projectile do not see its shape, and it may pass between them.
// Rounded: 2.7 counts as three.
constexpr double least_across = 2.5;

/// Depth to which two bodies press into each other when they meet at a speed: until they move alike, contact
/// takes k depth^2/2 per area, and what their relative motion has is mu speed^2/2, mu the reduced mass per
/// area. Tension of the fabric comes later and makes it less, by little. @param stiffness k, Pa/m @param
/// reduced mu, kg/m2 @param speed m/s
double depth_of_impact(double stiffness, double reduced, double speed) {
    return speed * std::sqrt(reduced / stiffness);
}

// A stop within the thickness h of the ply takes the pressure mu speed^2/h in the mean, and contact gives k h
// at the most: where the depth is more than h, what presses is behind the ply before the ply has its speed,
// and contact has not been felt.
void warn_of_soft_contact(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    const auto& contact = shot.scene.contact;
    const auto& units = shot.scene.units;
    const auto& ply = shot.struck();
    const double area = std::numbers::pi / 4 * projectile.diameter * projectile.diameter,
                 speed = projectile.velocity[2];
    const double m = ply.areal_density, M = projectile.mass / area, thickness = ply.contact_thickness;
    const auto say = [&](const char* key, double stiffness, const char* what, double depth) {
        found.push_back(fmt::format("{} of {} is too soft: at {} {} goes {} into a ply of {}", key,
                                    text_of(stiffness, units.area_stiffness), text_of(speed, units.speed),
                                    what, text_of(depth, units.length), text_of(thickness, units.length)));
    };
    if (contact.projectile) {
        const double depth = depth_of_impact(contact.projectile->stiffness, m * M / (m + M), speed);
        if (depth > thickness)
            say("contact.projectile.stiffness", contact.projectile->stiffness, "the projectile", depth);
    }
    if (contact.plies && shot.panel.plies.size() > 1) {
        const double depth = depth_of_impact(contact.plies->stiffness, m / 2, speed);  // of two equal plies
        if (depth > thickness)
            say("contact.plies.stiffness", contact.plies->stiffness, "a struck ply", depth);
    }
}

// A fabric under tension T per width presses with T/R on a bar of radius R, as a belt on its pulley. It
// breaks at E1 static_strain S/s.
void warn_of_soft_frame(const Shot& shot, Phrases& found) {
    const auto& units = shot.scene.units;
    const auto& fabric = shot.fabric_of(shot.panel.plies.back());
    const double radius = shot.scene.target->frame->edge_radius,
                 stiffness = shot.scene.contact.frame.stiffness;
    if (!fabric.failure || radius == 0) return;
    double tension = 0;
    for (const auto& system : fabric.systems())
        tension = std::max(tension, system.elastic.static_modulus * system.strength->static_strain *
                                        system.yarn.area / system.spacing);
    const double depth = tension / radius / stiffness;
    if (depth > fabric.contact_thickness)
        found.push_back(
            fmt::format("contact.frame.stiffness of {} is too soft: fabric about to break goes {} into the "
                        "bars, a ply is {}",
                        text_of(stiffness, units.area_stiffness), text_of(depth, units.length),
                        text_of(fabric.contact_thickness, units.length)));
}

// Coefficients of friction of dry fabrics are some tenths.
void warn_of_large_friction(const scene::Scene& scene, Phrases& found) {
    const auto check = [&](const char* key, const scene::ContactLaw& law) {
        if (!law.friction || law.friction->static_coefficient <= 1) return;
        found.push_back(fmt::format("contact.{}.friction is {:.4g}: coefficients of fabric are some tenths",
                                    key, law.friction->static_coefficient));
    };
    if (scene.contact.projectile) check("projectile", *scene.contact.projectile);
    if (scene.contact.plies) check("plies", *scene.contact.plies);
    check("frame", scene.contact.frame);
    for (const auto& clamp : scene.target->clamps)
        if (clamp && clamp->friction.static_coefficient > 1)
            found.push_back(
                fmt::format("friction in a clamp is {:.4g}: coefficients of fabric are some tenths",
                            clamp->friction.static_coefficient));
}

/// Length of the interval of grid lines that holds a coordinate.
double size_at(const std::vector<double>& lines, double at) {
    const auto after = std::ranges::upper_bound(lines, at) - lines.begin();
    const auto end = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(lines) - 1));
    return lines[end] - lines[end - 1];
}

void warn_of_coarse_contact(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    const auto length = [&](double value) { return text_of(value, shot.scene.units.length); };
    const auto place = place_at(projectile, -shot.struck().contact_thickness / 2);
    const auto& spacing = shot.scene.contact.spacing;
    double elements = 0, points = 0;
    for (std::size_t d = 0; d < 2; ++d) {
        const double size = size_at(d == 0 ? shot.panel.x : shot.panel.y,
                                    shot.panel.symmetry[d] ? std::abs(place[d]) : place[d]);
        elements = std::max(elements, size);
        points = std::max(points, spacing ? size / std::ceil(size / *spacing) : size);
    }
    if (projectile.diameter < least_across * std::max(elements, points))
        found.push_back(
            fmt::format("the projectile is {} across where it meets elements of {} with contact points {} "
                        "apart: with fewer than three "
                        "across it may pass between them",
                        length(projectile.diameter), length(elements), length(points)));
    else if (spacing && *spacing > projectile.diameter)
        found.push_back(fmt::format("contact.spacing is {}, more than the {} of the projectile",
                                    length(*spacing), length(projectile.diameter)));
}

/// @returns whether the projectile jumps over the fabric, which leaves nothing else to say
bool warn_of_steps(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    double thinnest = std::numeric_limits<double>::max();
    for (const auto& ply : shot.panel.plies)
        thinnest = std::min(thinnest, shot.fabric_of(ply).contact_thickness);
    const double way = projectile.speed() * shot.time_step;
    if (way <= thinnest) return false;
    found.push_back(fmt::format(
        "the projectile goes {} in a step, more than the {} that a ply is thick: it will pass through unseen",
        text_of(way, shot.scene.units.length), text_of(thinnest, shot.scene.units.length)));
    return true;
}

}  // namespace

void warn_of_projectile_contact(const Shot& shot, const scene::Projectile& projectile, Phrases& found) {
    if (warn_of_steps(shot, projectile, found)) return;
    if (has_plausible_weight(shot.struck())) warn_of_soft_contact(shot, projectile, found);
    warn_of_coarse_contact(shot, projectile, found);
}

void warn_of_contact(const Shot& shot, Phrases& found) {
    warn_of_large_friction(shot.scene, found);
    if (shot.scene.target->frame) warn_of_soft_frame(shot, found);
}

}  // namespace weavefront::app
