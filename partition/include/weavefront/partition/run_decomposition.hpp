#pragma once
/// @file
/// The decomposition at the start of a run.

#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/decomposition.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// Chooses among several decompositions the one with the shortest mean step over the run, by the committed
/// machine. The first one balances the cost of the whole run. For up to 256 parts, others give every part its
/// share of all columns and of each ring around the shot. Contact reaches the rings one after another, so the
/// parts are then balanced at every time of the run. The result depends on the arguments only: call it on one
/// rank and distribute it.
/// @param parts       1 up to the number of columns
/// @param ghost_reach as for `halo_sizes`
/// @throws std::invalid_argument when there are more parts than columns; std::runtime_error when METIS fails
Decomposition decompose_for_run(const scene::Scene& scene, const mesh::Panel& panel, int parts,
                                double ghost_reach);

}  // namespace weavefront::partition
