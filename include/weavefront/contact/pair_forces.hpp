#pragma once
/// @file
/// The forces of one facet on its targets.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Sums the point forces of one facet by target, so that a pair of facets has one PairForce. A target without
/// force has none.
class PairForces {
  public:
    /// Starts with another facet.
    void start() { indices_.clear(); }

    /// The force on one target. It is appended to `pairs` when first asked for.
    /// @param target        index in the facet's list of targets
    /// @param slave, master the facet and the target
    [[nodiscard]] PairForce& of(std::size_t target, const Facet& slave, const Facet& master,
                                std::vector<PairForce>& pairs) {
        if (target >= indices_.size()) indices_.resize(target + 1, -1);
        auto& index = indices_[target];
        if (index < 0) {
            index = static_cast<std::int32_t>(pairs.size());
            pairs.emplace_back(slave.nodes, master.nodes);
        }
        return pairs[static_cast<std::size_t>(index)];
    }

  private:
    std::vector<std::int32_t> indices_;  ///< in `pairs`, by target; -1: no force yet
};

}  // namespace weavefront::contact
