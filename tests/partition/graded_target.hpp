#pragma once
/// @file
/// A target refined under its projectile, with contact there.

#include "weavefront/mesh/panel.hpp"

namespace weavefront::test {

[[nodiscard]] inline scene::Scene graded_target() {
    scene::Scene scene;
    scene.fabrics.resize(1);
    scene::Target target;
    target.size = {0.2032, 0.2032};
    for (int ply = 0; ply < 8; ++ply) target.plies.push_back({.z = 0.25e-3 * ply});
    target.mesh = {.center = 1e-3, .edge = 3e-3, .growth = 1.08};
    scene.target = target;
    scene.projectiles = {scene::Projectile{.diameter = 5.38e-3}};
    scene.contact.projectile = scene.contact.plies = scene::ContactLaw{.stiffness = 1e13};
    return scene;
}

}  // namespace weavefront::test
