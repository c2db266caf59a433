#pragma once
/// @file
/// What is allowed but hardly meant.

#include <string>
#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// Phrases on quantities of a scene that do not go together, as a wrong unit makes them.
std::vector<std::string> doubts(const scene::Scene& scene);

/// The same on how far the projectile goes in a step. @param time_step s
std::vector<std::string> doubts(const scene::Scene& scene, double time_step);

}  // namespace weavefront::app
