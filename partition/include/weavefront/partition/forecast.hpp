#pragma once
/// @file
/// Time of a step on a number of ranks, by the cost model.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/decomposition.hpp"
#include "weavefront/partition/halo_sizes.hpp"
#include "weavefront/partition/machine.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// Quality of a decomposition, and the time of a step as a mean over the run. "Most" is the largest value of
/// a rank.
struct Forecast {
    int ranks = 1;
    std::int64_t columns = 0, elements = 0;
    double element_imbalance = 1;  ///< largest number of elements over the mean
    double cost_imbalance = 1;   ///< largest work of a rank over the mean, summed over the moments of the run
    std::int64_t cut_edges = 0;  ///< column faces between ranks
    std::int64_t most_neighbours = 0;  ///< neighbours of a rank
    std::int64_t most_halo_bytes = 0;  ///< sent or received by one rank per step
    std::int64_t halo_bytes = 0;       ///< sent by all ranks per step
    double seconds = 0;                ///< per step
};

/// Time of a step by the cost model, with the constants of Machine:
/// T = mean over the run of the maximum over ranks of
///     [elements element + nodes node + ply contact (elements (watch + renewals search) + elements in the
///     zone touch)] crowding + messages latency + bytes/bandwidth, and log2 R reductions.
/// The output of history and frames is not included.
/// @param decomposition of this panel
/// @param ghost_reach   as for `halo_sizes`
Forecast forecast(const scene::Scene& scene, const mesh::Panel& panel, const Decomposition& decomposition,
                  double ghost_reach, const Machine& machine);

/// Element-steps per second and rank, over those of one rank alone.
/// @param alone forecast of the same mesh, or of a coarser one, on one rank
double efficiency(const Forecast& forecast, const Forecast& alone);

/// Searches for candidates per step: proportional to the speed of the shot over the wave speed of the yarns.
double renewals(const scene::Scene& scene, const Machine& machine);

}  // namespace weavefront::partition
