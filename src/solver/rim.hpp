#pragma once
/// @file
/// Rims of the holes in the plies.

#include "weavefront/contact/surface.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/partition/halo_plan.hpp"

namespace weavefront::solver {

/// Finds which of the rank's own facets are on the rim of a hole; ghosts bring it with them. @note Collective
void find_rims(const parallel::Communicator& comm, const partition::HaloPlan& plan, contact::Surface& surface);

}  // namespace weavefront::solver
