#pragma once
/// @file
/// Which rank computes which columns.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/mesh/panel.hpp"

namespace weavefront::partition {

/// Owner of every column of a panel.
struct Decomposition {
    int parts = 1;
    std::vector<std::int32_t> owner;  ///< of each column

    /// Ascending columns of one part.
    [[nodiscard]] std::vector<std::int64_t> columns_of(int part) const;
};

/// Partitions the column graph with METIS (k-way, one constraint, imbalance 1.005); no part is left empty.
/// The result depends on the arguments only: call it on one rank and distribute it.
/// @param weights measured cost of each column, > 0
/// @param parts   1 up to the number of columns
/// @throws std::invalid_argument when there are more parts than columns; std::runtime_error when METIS fails
Decomposition decompose(const mesh::Panel& panel, std::span<const std::int32_t> weights, int parts);

/// Partitions the column graph so that every part gets its share of several loads at once (METIS, recursive
/// bisection, imbalance 1.01 or half of the heaviest column).
/// @param shares of each load: what each column has of it, >= 0, some above 0
/// @param seed   another one, another decomposition
/// @throws as above
Decomposition decompose(const mesh::Panel& panel, std::span<const std::vector<std::int32_t>> shares,
                        int parts, int seed);

/// Largest part's weight over the mean.
double imbalance(const Decomposition& decomposition, std::span<const std::int32_t> weights);

/// Column faces between parts.
std::int64_t cut_edges(const Decomposition& decomposition, const mesh::Panel& panel);

}  // namespace weavefront::partition
