#pragma once
/// @file
/// How far the points of a facet are from others at least.

#include <array>
#include <cmath>

#include "weavefront/contact/node_box.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// The points of a facet, from which others are seen.
class ContactPoints {
  public:
    /// @param corners, spanned those of the facet and of the part that its points span, m
    ContactPoints(const QuadratureRule& rule, const std::array<Vec3, 4>& corners,
                  const std::array<Vec3, 4>& spanned);

    /// A bound from below of the distance of any of the points to a box, m; 0 where none was found.
    [[nodiscard]] double min_distance(const NodeBox& box) const {
        return std::sqrt(box_.squared_distance(box));
    }

    /// The same to another facet: closer than to the box around it, and dearer. @param corners of the other,
    /// m
    [[nodiscard]] double min_distance(const std::array<Vec3, 4>& corners) const;

  private:
    std::size_t batches_;
    std::array<VectorLanes, most_batches> points_;
    NodeBox box_;  ///< around the points
};

}  // namespace weavefront::contact
