#pragma once
/// @file
/// What a step takes on a number of ranks, by the cost model.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/decomposition.hpp"
#include "weavefront/partition/halo_sizes.hpp"
#include "weavefront/partition/machine.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// Quality of a decomposition and the time of a step on it, a mean over the run. "Most" is the largest of the
/// ranks.
struct Forecast {
    int ranks = 1;
    std::int64_t columns = 0, elements = 0;
    double element_imbalance = 1;      ///< most elements over the mean
    double cost_imbalance = 1;         ///< most work of a moment over the mean, over all moments of the run
    std::int64_t cut_edges = 0;        ///< column faces between ranks
    std::int64_t most_neighbours = 0;  ///< ranks that share nodes with one
    std::int64_t most_halo_bytes = 0;  ///< sent or received by one rank a step
    std::int64_t halo_bytes = 0;       ///< sent by all a step
    double seconds = 0;                ///< a step
};

/// T = mean over the run of the most over ranks of [elements element + nodes node + ply contact (elements
/// (watch + renewals search) + elements in the zone touch)] crowding + messages latency + bytes/bandwidth,
/// and log2 R reductions. Rows of the history and frames come on top.
/// @param decomposition of this panel
/// @param ghost_reach   as for `halo_sizes`
Forecast forecast(const scene::Scene& scene, const mesh::Panel& panel, const Decomposition& decomposition,
                  double ghost_reach, const Machine& machine);

/// Element-steps a second and rank, over those of one rank alone. @param alone the forecast of the same mesh,
/// or of a coarser one, on one rank
double efficiency(const Forecast& forecast, const Forecast& alone);

/// Renewals of what may meet what, a step: in proportion to the speed of the shot over that of the wave in
/// the yarns.
double renewals(const scene::Scene& scene, const Machine& machine);

}  // namespace weavefront::partition
