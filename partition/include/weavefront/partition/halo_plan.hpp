#pragma once
/// @file
/// Which nodes a rank shares with which other ranks.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/mesh/part.hpp"
#include "weavefront/partition/decomposition.hpp"

namespace weavefront::partition {

/// Nodes shared with one other rank, ascending global order on both sides.
struct Neighbour {
    int rank = 0;
    std::vector<std::int32_t> nodes;  ///< local indices
};

struct HaloPlan {
    std::vector<Neighbour> neighbours;  ///< ascending ranks
    std::vector<bool> owned;            ///< of each local node: true on the lowest of the ranks that hold it
};

/// The halo of one part, found from the decomposition alone: no communication.
HaloPlan make_halo_plan(const mesh::Panel& panel, const Decomposition& decomposition, const mesh::Part& part,
                        int rank);

}  // namespace weavefront::partition
