#include "weavefront/solver/contact_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::solver {

namespace {

// A projectile so much heavier than the fabric under it stands still to the highest mode: far less than the
// safety factor leaves.
constexpr double negligible = 0.01;

// A force along the surface of a body that turns moves its point by up to so much more than the centre of
// mass: 1 + (arm/radius of gyration)^2. It is 3.5 for a sphere, less than 4 for a cylinder, and 16 at the tip
// of a slender cone, all of uniform density.
constexpr double turning = 16;

/// Springs of contact on one mass per area, in ratio to one spring per area.
struct Springs {
    double normal, tangential;
};

/// Of contact springs over a mass per area. @param reduced mass per area that the law's fraction of critical
/// damping refers to
ContactModes modes_of(const scene::ContactLaw& law, const Springs& springs, double mass, double reduced) {
    ContactModes modes{
        .stiffness = springs.normal * law.unloading * law.stiffness / mass,
        .damping = springs.normal * 2 * law.damping * std::sqrt(law.stiffness * reduced) / mass};
    if (law.friction) {
        const auto& [of_static, mu, ratio] = *law.friction;
        const double slipping = modes.stiffness * (1 + std::sqrt(1 + mu * mu)) / 2;
        modes.tangential = springs.tangential * ratio * law.stiffness / mass;
        modes.stiffness = std::max(slipping - modes.tangential, 0.0);
    }
    return modes;
}

/// The same in all directions.
ContactModes modes_of(const scene::ContactLaw& law, double springs, double mass, double reduced) {
    return modes_of(law, {springs, springs}, mass, reduced);
}

/// Plies that stick to each other and to both jaws: a chain of n masses between walls, whose highest mode has
/// 2 + 2 cos(pi/(n + 1)) springs over one mass. 1/s2 @param lightest ply, kg/m2
double clamp_mode(const scene::Scene& scene, double lightest) {
    const auto plies = static_cast<double>(scene.target->plies.size());
    double highest = 0;
    for (const auto& clamp : scene.target->clamps)
        if (clamp)
            highest = std::max(highest, 2 * (1 + scene::cosine(std::numbers::pi / (plies + 1))) *
                                            clamp->friction.stiffness_ratio * scene.contact.frame.stiffness /
                                            lightest);
    return highest;
}

/// kg/m2
double mass_per_area(const scene::Projectile& projectile) {
    const double radius = projectile.diameter / 2;
    return projectile.mass / (std::numbers::pi * radius * radius);
}

/// Of fabric between two of some bodies at the most: each part is the sum of its two largest values.
ContactModes of_two(std::span<const ContactModes> bodies) {
    const auto largest = [&](double ContactModes::*part) {
        double first = 0, second = 0;
        for (const auto& modes : bodies) {
            const double value = modes.*part;
            second = std::max(second, std::min(first, value));
            first = std::max(first, value);
        }
        return first + second;
    };
    return {.stiffness = largest(&ContactModes::stiffness),
            .damping = largest(&ContactModes::damping),
            .tangential = largest(&ContactModes::tangential)};
}

/// Contact of projectiles with fabric, and of light ones with the frame.
struct OfProjectiles {
    std::vector<ContactModes> with_fabric, with_frame;
};

OfProjectiles modes_of_projectiles(const scene::Scene& scene, double lightest) {
    const auto& law = *scene.contact.projectile;
    OfProjectiles all;
    for (const auto& projectile : scene.projectiles) {
        const double mass = mass_per_area(projectile), point = projectile.turns ? turning : 1;
        const bool counts = lightest > negligible * mass;
        const Springs springs =
            counts ? Springs{1 + lightest / mass, 1 + point * lightest / mass} : Springs{1, 1};
        all.with_fabric.push_back(modes_of(law, springs, lightest, lightest));
        if (counts && scene.target->frame) all.with_frame.push_back(modes_of(law, {1, point}, mass, mass));
    }
    return all;
}

}  // namespace

ContactModes contact_modes(const scene::Scene& scene) {
    double lightest = std::numeric_limits<double>::max();
    for (const auto& ply : scene.target->plies)
        lightest = std::min(lightest, scene.fabrics[static_cast<std::size_t>(ply.fabric)].areal_density);
    ContactModes sum;
    const auto add = [&](const ContactModes& modes) {
        sum.stiffness += modes.stiffness, sum.damping += modes.damping;
        sum.tangential += modes.tangential;
    };
    const auto plies = static_cast<double>(scene.target->plies.size());
    if (scene.contact.plies && plies > 1) {
        const double cosine = scene::cosine(std::numbers::pi / (2 * plies));
        add(modes_of(*scene.contact.plies, 4 * cosine * cosine, lightest, lightest / 2));
    }
    if (scene.contact.projectile) {
        const auto projectiles = modes_of_projectiles(scene, lightest);
        add(of_two(projectiles.with_fabric));
        add(of_two(projectiles.with_frame));
    }
    if (scene.target->frame) add(modes_of(scene.contact.frame, 1, lightest, lightest));
    sum.tangential += clamp_mode(scene, lightest);
    return sum;
}

double joint_frequency_squared(double in_plane, double out_of_plane, double contact, double sine_squared) {
    if (out_of_plane >= in_plane) return out_of_plane + contact;
    const double half = (in_plane - out_of_plane - contact) / 2;
    return (in_plane + out_of_plane + contact) / 2 +
           std::sqrt(half * half + contact * (in_plane - out_of_plane) * sine_squared);
}

// From above, by the case that all act in one direction; each turn brings it nearer to the solution and
// leaves it above.
double damped_frequency_squared(double in_plane, double out_of_plane, const ContactModes& contact,
                                double sine_squared) {
    in_plane += contact.tangential, out_of_plane += contact.tangential;
    const double half = contact.damping / 2;
    double omega = half + std::sqrt(half * half + std::max(in_plane, out_of_plane) + contact.stiffness);
    constexpr int turns = 8;
    for (int i = 0; i < turns && contact.damping > 0; ++i)
        omega = std::sqrt(joint_frequency_squared(in_plane, out_of_plane,
                                                  contact.stiffness + omega * contact.damping, sine_squared));
    return contact.damping > 0
               ? omega * omega
               : joint_frequency_squared(in_plane, out_of_plane, contact.stiffness, sine_squared);
}

double in_plane_of_joint(double joint, double out_of_plane, double contact, double sine_squared) {
    if (sine_squared == 1) return joint - contact;
    const double cosine_squared = 1 - sine_squared, rest = joint - out_of_plane - contact * cosine_squared;
    return rest > 0 ? joint - contact * sine_squared * (1 + contact * cosine_squared / rest) : 0;
}

}  // namespace weavefront::solver
