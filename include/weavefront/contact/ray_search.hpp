#pragma once
/// @file
/// The search of one facet's rays for the facets that they hit.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/ray_targets.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// A slave facet at the present positions.
struct SlaveGeometry {
    const Facet& facet;
    const QuadratureRule& rule;
    std::array<Vec3, 4> corners;  ///< m
    std::array<Vec3, 4> normals;  ///< of any length
};

/// Rays of one facet and the targets to try them on, one after the other. The master of a point is the first
/// target in this order that its ray hits.
///
/// The nearest candidate is nearly always hit by all rays. Therefore the other candidates are listed only
/// when a ray has missed it.
class RaySearch {
  public:
    /// @param targets    scratch for the list of targets, reused from facet to facet
    /// @param candidates of the slave
    /// @param nearest    the candidate that RayTargets would list first; -1: not known
    /// @param x          present positions, m
    RaySearch(RayTargets& targets, const SlaveGeometry& slave, FacetRanges candidates, std::int32_t nearest,
              const Surface& surface, const ContactDistances& distances, std::span<const Vec3> x)
        : targets_(targets),
          rays_(slave.rule, slave.corners, slave.normals, distances.max_penetration(), distances.most()),
          candidates_(candidates),
          surface_(surface),
          distances_(distances),
          x_(x),
          is_complete_(nearest < 0) {
        targets_.start(slave.facet, slave.corners);
        const FacetRange only_nearest{nearest, 1};
        list(is_complete_ ? candidates_ : FacetRanges({&only_nearest, 1}));
    }

    /// Rays of a batch of points.
    [[nodiscard]] const Rays& rays(std::size_t batch) const { return rays_.batches[batch]; }

    /// Local index of the k-th target; none after the last one.
    [[nodiscard]] std::optional<std::int32_t> target(std::size_t k) {
        if (k == targets_.size() && !is_complete_) {
            list(candidates_);
            is_complete_ = true;
        }
        if (k == targets_.size()) return std::nullopt;
        return targets_[k];
    }

  private:
    void list(const FacetRanges& candidates) { targets_.add(candidates, rays_, surface_, distances_, x_); }

    RayTargets& targets_;
    NormalRays rays_;
    FacetRanges candidates_;
    const Surface& surface_;
    const ContactDistances& distances_;
    std::span<const Vec3> x_;
    bool is_complete_;  ///< all candidates were listed
};

}  // namespace weavefront::contact
