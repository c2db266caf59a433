#pragma once
/// @file
/// What is allowed but hardly meant.

#include <string>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// Phrases on quantities of a scene that do not go together or that no material has, as a wrong unit makes
/// them, in the units of the scene.
/// @param panel     of its target
/// @param time_step s; 0: not known
std::vector<std::string> warnings(const scene::Scene& scene, const mesh::Panel& panel, double time_step);

}  // namespace weavefront::app
