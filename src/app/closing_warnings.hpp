#pragma once
/// @file
/// What a finished run has to be questioned for.

#include <string>
#include <vector>

#include "weavefront/solver/simulation.hpp"

namespace weavefront::app {

/// One line each. @param last balance of the run @note Collective
std::vector<std::string> closing_warnings(const solver::Simulation& simulation, const solver::Balance& last);

}  // namespace weavefront::app
