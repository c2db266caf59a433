#pragma once
/// @file
/// Nodes that a rank shares with other ranks.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/mesh/part.hpp"
#include "weavefront/partition/decomposition.hpp"

namespace weavefront::partition {

/// Nodes shared with one other rank, in ascending global order on both ranks.
struct Neighbour {
    int rank = 0;
    std::vector<std::int32_t> nodes;  ///< local indices
};

/// Neighbours of a rank and ownership of its nodes.
struct HaloPlan {
    std::vector<Neighbour> neighbours;  ///< ascending ranks
    std::vector<bool> owned;            ///< by local node: true on the lowest rank that holds it
};

/// The halo of one part. It follows from the decomposition without communication.
HaloPlan make_halo_plan(const mesh::Panel& panel, const Decomposition& decomposition, const mesh::Part& part,
                        int rank);

}  // namespace weavefront::partition
