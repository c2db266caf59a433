#pragma once
/// @file
/// Lower bounds of the distances of a facet's points to other facets.

#include <array>
#include <cmath>

#include "weavefront/contact/node_box.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// The integration points of a facet at their present positions.
class ContactPoints {
  public:
    /// @param corners, spanned corners of the facet, and of the part of it that its points span, m
    ContactPoints(const QuadratureRule& rule, const std::array<Vec3, 4>& corners,
                  const std::array<Vec3, 4>& spanned);

    /// Lower bound of the distance of all points to a box, m.
    [[nodiscard]] double min_distance(const NodeBox& box) const {
        return std::sqrt(box_.squared_distance(box));
    }

    /// Lower bound of the distance of all points to a facet, m. It is closer than the bound to the box around
    /// the facet, at a higher cost. @param corners of the facet, m
    [[nodiscard]] double min_distance(const std::array<Vec3, 4>& corners) const;

  private:
    std::size_t batches_;
    std::array<VectorLanes, most_batches> points_;
    NodeBox box_;  ///< around the points
};

}  // namespace weavefront::contact
