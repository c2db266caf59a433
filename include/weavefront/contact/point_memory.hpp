#pragma once
/// @file
/// The state of contact points between plies that lasts from step to step.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/facet_memory.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/penalty.hpp"

namespace weavefront::contact {

/// Penetrations of the points of one facet, [batch].
using FacetPoints = std::array<PenetrationLanes, most_batches>;

/// Penetrations of the facets in contact, and the dissipated budget of every owned facet. Facets without
/// contact have no penetrations and take no memory for them.
class PointMemory {
  public:
    /// @param facets number of owned facets
    explicit PointMemory(std::size_t facets)
        : penetrations_(static_cast<std::int32_t>(facets)), dissipated_budgets_(facets) {}

    /// Whether a facet has penetrations.
    [[nodiscard]] bool holds(std::int32_t facet) const { return penetrations_.find(facet) != nullptr; }

    /// Penetrations of a facet; zero where it has none.
    [[nodiscard]] FacetPoints recall(std::int32_t facet) const {
        const auto* points = penetrations_.find(facet);
        return points ? *points : FacetPoints{};
    }
    /// Replaces the penetrations of a facet.
    void keep(std::int32_t facet, const FacetPoints& points) { penetrations_.take(facet) = points; }
    /// Drops the penetrations of a facet. Its dissipated budget stays.
    void forget(std::int32_t facet) { penetrations_.forget(facet); }

    /// Dissipated budget of a facet, J/m2: see PenaltyLaw.
    [[nodiscard]] double& dissipated_budget(std::int32_t facet) {
        return dissipated_budgets_[static_cast<std::size_t>(facet)];
    }

    /// Appends the state of a facet to a record, for another rank.
    void save(std::int32_t facet, std::vector<double>& record) const;
    /// Sets the state of a facet. @param record starts with the numbers of `save` @return the rest of it
    std::span<const double> restore(std::int32_t facet, std::span<const double> record);

  private:
    FacetMemory<FacetPoints> penetrations_;
    std::vector<double> dissipated_budgets_;  ///< J/m2
};

}  // namespace weavefront::contact
