#include "weavefront/solver/contact_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::solver {

namespace {

// A projectile so much heavier than the fabric under it stands still to the highest mode: far less than the
// safety factor leaves.
constexpr double negligible = 0.01;

/// Of `springs` contact springs over a mass per area. @param reduced mass per area that the law's fraction of
/// critical damping refers to
ContactModes modes_of(const scene::ContactLaw& law, double springs, double mass, double reduced) {
    return {springs * law.unloading * law.stiffness / mass,
            springs * 2 * law.damping * std::sqrt(law.stiffness * reduced) / mass};
}

}  // namespace

ContactModes contact_modes(const scene::Scene& scene) {
    double lightest = std::numeric_limits<double>::max();
    for (const auto& ply : scene.target->plies)
        lightest = std::min(lightest, scene.fabrics[static_cast<std::size_t>(ply.fabric)].areal_density);
    ContactModes sum;
    const auto add = [&](const ContactModes& modes) {
        sum.stiffness += modes.stiffness, sum.damping += modes.damping;
    };
    const auto plies = static_cast<double>(scene.target->plies.size());
    if (scene.contact.plies && plies > 1) {
        const double cosine = scene::cosine(std::numbers::pi / (2 * plies));
        add(modes_of(*scene.contact.plies, 4 * cosine * cosine, lightest, lightest / 2));
    }
    if (scene.contact.projectile && scene.projectile) {
        const double radius = scene.projectile->diameter / 2,
                     mass = scene.projectile->mass / (std::numbers::pi * radius * radius);
        const bool counts = lightest > negligible * mass;
        add(modes_of(*scene.contact.projectile, counts ? 1 + lightest / mass : 1, lightest, lightest));
        if (counts && scene.target->frame) add(modes_of(*scene.contact.projectile, 1, mass, mass));
    }
    if (scene.target->frame) add(modes_of(scene.contact.frame, 1, lightest, lightest));
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
