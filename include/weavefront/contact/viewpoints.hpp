#pragma once
/// @file
/// How far the points of a facet are from others at least.

#include <array>

#include "weavefront/contact/facet_lines.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// The points of a facet, from which others are seen.
class Viewpoints {
  public:
    /// @param corners, spanned those of the facet and of the part that its points span, m
    Viewpoints(const QuadratureRule& rule, const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& spanned);

    /// A bound from below of the distance of any of the points to another facet, m; 0 where none was found.
    /// @param corners of the other, m
    /// @param enough  a bound as large as this may be returned without looking for a larger one, m
    [[nodiscard]] double distance_to(const std::array<Vec3, 4>& corners, double enough) const;

  private:
    std::size_t batches_;
    std::array<VectorLanes, most_batches> points_;
    Box box_;  ///< around the points
};

}  // namespace weavefront::contact
