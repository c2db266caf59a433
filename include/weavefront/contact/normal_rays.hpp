#pragma once
/// @file
/// Lines along which a facet looks for what it touches.

#include <array>
#include <optional>

#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/ray.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

// Both sides of a gap between plies are bilinear over an element, with edges of the other ply's elements in
// between: more points than this along an edge resolve nothing. (The projectile's edge is finer than any
// element; its contact knows no such bound.)
inline constexpr int most_points_along_edge = 4;
inline constexpr std::size_t most_batches =
    (most_points_along_edge * most_points_along_edge + batch_width - 1) / batch_width;

/// Lines through the points of a facet along the smoothed normals.
class NormalRays {
  public:
    /// @param corners, normals of the facet, m and of any length
    /// @param back, ahead      how far against and along the lines something may be met, m
    NormalRays(const QuadratureRule& rule, const std::array<Vec3, 4>& corners,
               const std::array<Vec3, 4>& normals, double back, double ahead);

    /// Whether a box meets the one around all that the lines may meet.
    [[nodiscard]] bool may_reach(const Box& box);

    std::array<Rays, most_batches> batches;

  private:
    [[nodiscard]] Box stretch() const;

    std::size_t batch_count_;
    double back_, ahead_;
    std::optional<Box> stretch_;  ///< where it was needed: most often the box meets that of one line
};

}  // namespace weavefront::contact
