#pragma once
/// @file
/// Rims of the holes in the plies.

#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// Finds which of the rank's own facets are on the edge of a hole, or on an edge of their ply that may move;
/// ghosts bring it with them.
/// @note Collective
void find_free_edges(const parallel::Communicator& comm, const mesh::Panel& panel, Model& model);

}  // namespace weavefront::solver
