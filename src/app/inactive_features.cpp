#include "inactive_features.hpp"

#include <algorithm>

namespace weavefront::app {

std::vector<std::string> inactive_features(const scene::Scene& scene, int ranks) {
    std::vector<std::string> phrases;
    const auto unless = [&](bool asked_for, const char* phrase) {
        if (!asked_for) phrases.emplace_back(phrase);
    };
    const auto any_fabric = [&](auto has) { return std::ranges::any_of(scene.fabrics, has); };
    unless(any_fabric([](const auto& f) { return f.thickness > 0; }),
           "crimp (thickness is 0: straight yarns)");
    unless(any_fabric([](const auto& f) { return f.elastic.viscosity > 0; }),
           "viscosity of the yarns (no elastic.viscosity)");
    unless(any_fabric([](const auto& f) { return f.failure.has_value(); }),
           "failure and erosion (no failure)");
    unless(any_fabric([](const auto& f) { return f.failure && f.failure->scatter; }),
           "scatter of strength (no failure.scatter)");
    unless(any_fabric([](const auto& f) { return f.lateral.has_value(); }),
           "packing of the yarns (no lateral)");
    unless(any_fabric([](const auto& f) { return f.friction > 0; }), "yarn friction (no friction)");
    unless(any_fabric([](const auto& f) { return f.transverse_shear > 0; }),
           "transverse shear (no transverse_shear: hourglass control resists warping)");
    unless(!scene.projectiles.empty(), "projectile and its contact (no projectile)");
    unless(scene.contact.plies && scene.target && scene.target->plies.size() > 1,
           "contact between plies (no contact.plies, or a single ply)");
    unless(scene.has_contact_friction(), "friction of contact (no friction of a contact)");
    unless(scene.target && scene.target->frame, "frame and its contact (no edge rests on it)");
    unless(scene.damping > 0, "mass damping (no damping)");
    unless(ranks > 1, "halo exchange (one rank)");
    return phrases;
}

}  // namespace weavefront::app
