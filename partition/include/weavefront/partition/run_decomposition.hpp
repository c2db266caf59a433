#pragma once
/// @file
/// The decomposition with which a run begins.

#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/decomposition.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// Of several decompositions the one on which a step takes the least in the mean over the run, by the
/// committed machine: one that balances the cost of the whole run, and, for up to 256 parts, some that give
/// every part its share of all columns and of each ring around the shot that contact reaches one after
/// another, so that the parts are balanced at every time of the run. The result depends on the arguments
/// only: call it on one rank and distribute it.
/// @param parts       1 up to the number of columns
/// @param ghost_reach as for `halo_sizes`
/// @throws std::invalid_argument when there are more parts than columns; std::runtime_error when METIS fails
Decomposition decompose_for_run(const scene::Scene& scene, const mesh::Panel& panel, int parts,
                                double ghost_reach);

}  // namespace weavefront::partition
