#pragma once
/// @file
/// Facets on which the rays of a facet are tried.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/swept_bounds.hpp"

namespace weavefront::contact {

/// Targets of the rays of one facet, in the order of trial: nearest ply first, and within a ply nearest
/// centre first.
class RayTargets {
  public:
    /// Starts with an empty list, for another facet. @param corners of the facet, m
    void start(const Facet& facet, const std::array<Vec3, 4>& corners);

    /// Lists the candidates that the rays may hit within contact distance. A target listed by an earlier call
    /// stays the first. A ply hides the plies behind it where it lies over the facet, as seen along z, and
    /// has no free edge there. The present positions decide, not those of the search for candidates.
    /// @param rays of the facet
    /// @param x    present positions, m
    void add(const FacetRanges& candidates, NormalRays& rays, const Surface& surface,
             const ContactDistances& distances, std::span<const Vec3> x);

    [[nodiscard]] std::size_t size() const { return targets_.size(); }
    [[nodiscard]] std::int32_t operator[](std::size_t k) const { return targets_[k].facet; }

  private:
    struct Near {
        std::int32_t facet, ply;
        double apart;  ///< square of the distance of the centres, m2
    };
    std::int32_t ply_ = 0;
    Vec3 centre_, normal_;
    Footprint footprint_;
    double front_ = 0;  ///< of the facet's foremost corner along its normal, m
    std::vector<Near> targets_;
};

}  // namespace weavefront::contact
