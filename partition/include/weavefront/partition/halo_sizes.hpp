#pragma once
/// @file
/// Sizes of the parts of a decomposition and of their exchange, without building them.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/decomposition.hpp"

namespace weavefront::partition {

/// Columns and nodes of one part, and its messages per step.
struct PartSizes {
    std::int64_t columns = 0, nodes = 0;  ///< nodes of all plies, including shared ones
    std::int64_t neighbours = 0;          ///< parts that share nodes
    std::int64_t messages = 0;            ///< sent
    std::int64_t bytes_sent = 0, bytes_received = 0;
    std::int64_t ghosts = 0;  ///< nodes of other parts within reach of contact, all plies
};

/// Bytes of a node's force sum.
inline constexpr std::int64_t force_bytes = 24;

/// Sizes of each part as the solver builds it at the start. Force sums are exchanged between all parts that
/// hold a node or have it as a ghost. Only the dense values count, see parallel::SendList: the forces on
/// ghosts are few.
/// @param ghost_reach distance along x and y up to which columns of other parts are ghosts, m; 0: no ghosts
std::vector<PartSizes> halo_sizes(const mesh::Panel& panel, const Decomposition& decomposition,
                                  double ghost_reach);

/// Parts whose columns lie around a footprint node, ascending, without repetition.
struct Holders {
    std::array<std::int32_t, 4> parts{};
    int count = 0;

    [[nodiscard]] bool has(std::int32_t part) const {
        for (int i = 0; i < count; ++i)
            if (parts[static_cast<std::size_t>(i)] == part) return true;
        return false;
    }
};
Holders holders_of(const mesh::Panel& panel, const Decomposition& decomposition, std::int64_t footprint_node);

}  // namespace weavefront::partition
