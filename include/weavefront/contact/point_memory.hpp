#pragma once
/// @file
/// What the points of facets remember.

#include <array>
#include <cstdint>
#include <vector>

#include "weavefront/contact/facet_lines.hpp"
#include "weavefront/contact/penalty.hpp"

namespace weavefront::contact {

using FacetPoints = std::array<PenetrationLanes, most_batches>;

/// Points of the facets that touch something; the others have no memory and take no room.
class PointMemory {
  public:
    explicit PointMemory(std::size_t facets) : places_(facets, -1) {}

    [[nodiscard]] bool holds(std::int32_t facet) const { return place(facet) >= 0; }

    /// Those of a facet; fresh ones where it holds none.
    [[nodiscard]] FacetPoints recall(std::int32_t facet) const {
        return holds(facet) ? points_[static_cast<std::size_t>(place(facet))] : FacetPoints{};
    }

    void keep(std::int32_t facet, const FacetPoints& points) {
        if (!holds(facet)) {
            if (free_.empty()) {
                free_.push_back(static_cast<std::int32_t>(points_.size()));
                points_.emplace_back();
            }
            places_[static_cast<std::size_t>(facet)] = free_.back();
            free_.pop_back();
        }
        points_[static_cast<std::size_t>(place(facet))] = points;
    }

    void forget(std::int32_t facet) {
        if (!holds(facet)) return;
        free_.push_back(place(facet));
        places_[static_cast<std::size_t>(facet)] = -1;
    }

  private:
    [[nodiscard]] std::int32_t place(std::int32_t facet) const { return places_[static_cast<std::size_t>(facet)]; }

    std::vector<std::int32_t> places_;  ///< of each facet, or -1
    std::vector<FacetPoints> points_;
    std::vector<std::int32_t> free_;  ///< places
};

}  // namespace weavefront::contact
