#pragma once
/// @file
/// Which ranks compute which variants.

#include <cstddef>
#include <span>
#include <vector>

namespace weavefront::study {

/// One variant to compute.
struct Job {
    double cost;  ///< expected, any unit
    int columns;  ///< most ranks that can share it
};

/// First the longest variants, each on all ranks, one after another; then groups of ranks side by side, each
/// taking the next one when it is done.
struct RankPlan {
    std::vector<std::size_t> order;  ///< indices of the jobs, longest first
    std::size_t together = 0;        ///< so many of the first are computed by all ranks
    int groups = 1;                  ///< for the others
    double expected = 0;             ///< duration, in the unit of the costs
};

/// The plan that is expected to end first. Side by side there is neither halo nor idling, but the longest
/// variant may keep one group busy when all others are done.
/// @param jobs  what is left to compute
/// @param ranks at least 1
RankPlan plan_ranks(std::span<const Job> jobs, int ranks);

/// The group of a rank: neighbours, groups as equal as can be. @param groups at most `ranks`
int group_of(int rank, int ranks, int groups);

}  // namespace weavefront::study
