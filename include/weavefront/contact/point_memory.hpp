#pragma once
/// @file
/// What the points of facets remember.

#include <array>
#include <cstdint>

#include "weavefront/contact/facet_memory.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/penalty.hpp"

namespace weavefront::contact {

using FacetPoints = std::array<PenetrationLanes, most_batches>;

/// Points of the facets that touch something; the others have no memory and take no room.
class PointMemory {
  public:
    explicit PointMemory(std::size_t facets) : memories_(static_cast<std::int32_t>(facets)) {}

    [[nodiscard]] bool holds(std::int32_t facet) const { return memories_.find(facet) != nullptr; }

    /// Those of a facet; fresh ones where it holds none.
    [[nodiscard]] FacetPoints recall(std::int32_t facet) const {
        const auto* points = memories_.find(facet);
        return points ? *points : FacetPoints{};
    }

    void keep(std::int32_t facet, const FacetPoints& points) { memories_.take(facet) = points; }
    void forget(std::int32_t facet) { memories_.forget(facet); }

  private:
    FacetMemory<FacetPoints> memories_;
};

}  // namespace weavefront::contact
