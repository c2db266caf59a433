#pragma once
/// @file
/// The cases of the stability table.

#include <string>
#include <vector>

#include "trial.hpp"

namespace weavefront::stability {

/// All cases in the order of the table.
std::vector<Case> all_cases();

}  // namespace weavefront::stability
