#pragma once
/// @file
/// Decomposition of the columns of a panel into parts, one for each rank.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/mesh/panel.hpp"

namespace weavefront::partition {

/// Owner of every column of a panel.
struct Decomposition {
    int parts = 1;
    std::vector<std::int32_t> owner;  ///< by column

    /// Ascending columns of one part.
    [[nodiscard]] std::vector<std::int64_t> columns_of(int part) const;
};

/// Partitions the column graph with METIS (k-way, one constraint, imbalance 1.005). No part is empty. The
/// result depends on the arguments only: call it on one rank and distribute it.
/// @param weights cost of each column, > 0
/// @param parts   1 up to the number of columns
/// @throws std::invalid_argument when there are more parts than columns; std::runtime_error when METIS fails
Decomposition decompose(const mesh::Panel& panel, std::span<const std::int32_t> weights, int parts);

/// Partitions the column graph with METIS so that every part gets its share of several loads at once
/// (recursive bisection, imbalance 1.01 or half of the heaviest column).
/// @param shares by load and column: share of the load, >= 0 and not all 0
/// @param seed   of METIS; every seed gives another decomposition
/// @throws as above
Decomposition decompose(const mesh::Panel& panel, std::span<const std::vector<std::int32_t>> shares,
                        int parts, int seed);

/// Weight of the heaviest part over the mean of all parts.
double imbalance(const Decomposition& decomposition, std::span<const std::int32_t> weights);

/// Number of column faces between parts.
std::int64_t cut_edges(const Decomposition& decomposition, const mesh::Panel& panel);

}  // namespace weavefront::partition
