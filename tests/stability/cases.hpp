#pragma once
/// @file
/// The cases of the stability table.

#include <string>
#include <vector>

#include "trial.hpp"

namespace weavefront::stability {

/// The scene that the cases change: three plies of the paper's fabric with every part of the model, a quarter of a small panel.
extern const std::string base_scene;

/// All cases in the order of the table.
std::vector<Case> all_cases();

}  // namespace weavefront::stability
