#pragma once
/// @file
/// What a scene does not ask for and is therefore not computed.

#include <string>
#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// One phrase a feature, for the log and summary.json. @param ranks of the run
std::vector<std::string> inactive_features(const scene::Scene& scene, int ranks);

}  // namespace weavefront::app
