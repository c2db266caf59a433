#pragma once
/// @file
/// A model in motion on other ranks.

#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// The same state on ranks that hold other columns: nothing of what follows differs by a bit. Ghosts and
/// candidates of contact are left to be rebuilt.
/// @param model between two steps: forces have been used, and erosions are known to the surface
/// @note Collective
Model redistribute(const scene::Scene& scene, const mesh::Panel& panel,
                   const partition::Decomposition& decomposition, Model& model,
                   const parallel::Communicator& comm);

}  // namespace weavefront::solver
