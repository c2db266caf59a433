#pragma once
/// @file
/// Facets that the lines of a facet try.

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

/// In the order in which lines try them: nearest ply first, in it the nearest centre first.
class RayTargets {
  public:
    /// Starts with none, for another facet at hand. @param corners of the facet, m
    void start(const Facet& facet, const std::array<Vec3, 4>& corners);

    /// Adds what of some candidates its lines may touch. The one that is there already stays the first. A ply
    /// hides those behind it where it comes within the touching depth, as seen along z, and none of its
    /// facets there is on a rim: what was near a rim at the time of the search for candidates does not
    /// matter.
    void add(const FacetRanges& candidates, NormalRays& rays, const Surface& surface,
             const ContactDistances& distances, std::span<const Vec3> x);

    [[nodiscard]] std::size_t size() const { return targets_.size(); }
    [[nodiscard]] std::int32_t operator[](std::size_t k) const { return targets_[k].facet; }

  private:
    struct Near {
        std::int32_t facet, ply;
        double apart;  ///< of the centres, m2
    };
    std::int32_t ply_ = 0;
    Vec3 centre_, normal_;
    Footprint footprint_;
    double front_ = 0;  ///< of the facet's foremost corner along its normal, m
    std::vector<Near> targets_;
};

}  // namespace weavefront::contact
