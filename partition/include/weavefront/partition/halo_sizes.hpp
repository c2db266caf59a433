#pragma once
/// @file
/// What every part of a decomposition holds and exchanges, without building it.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/decomposition.hpp"

namespace weavefront::partition {

/// Messages and bytes of one part a step, and what it computes.
struct PartSizes {
    std::int64_t columns = 0, nodes = 0;  ///< nodes of all plies, shared ones included
    std::int64_t neighbours = 0;          ///< parts that share nodes
    std::int64_t messages = 0;            ///< sent
    std::int64_t bytes_sent = 0, bytes_received = 0;
    std::int64_t ghosts = 0;  ///< nodes of other parts near enough for contact, all plies
};

/// Bytes of a node's force sum.
inline constexpr std::int64_t force_bytes = 24;

/// The exchange of each part as the solver links it at the start: force sums between all parts that hold a
/// node or, where plies touch, have it as a ghost. Counted are those that always travel, from parts that hold
/// the node: what is pressed on ghosts is little.
/// @param ghost_reach distance from a part's columns up to which those of others are its ghosts, along x and
/// along y, m; 0: no ghosts
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
