#pragma once
/// @file
/// A target of three plies with unequal sides.

#include "weavefront/mesh/panel.hpp"

namespace weavefront::test {

[[nodiscard]] inline scene::Scene small_target() {
    scene::Scene scene;
    scene.fabrics.resize(1);
    scene::Target target;
    target.size = {0.02, 0.03};
    target.plies = {{.z = 0}, {.z = 0.25e-3}, {.z = 0.6e-3}};
    target.mesh = {.center = 1e-3, .edge = 3e-3, .growth = 1.2};
    scene.target = target;
    return scene;
}

}  // namespace weavefront::test
