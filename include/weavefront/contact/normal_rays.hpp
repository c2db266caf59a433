#pragma once
/// @file
/// Rays from the points of a facet along the normals of its ply.

#include <array>
#include <optional>

#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/ray.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

// Both sides of a gap between plies are bilinear, with a few element edges in between. More points along an
// edge than this resolve nothing. Contact with the projectile has no such bound, since its edges are finer
// than elements.
inline constexpr int most_points_along_edge = 4;
inline constexpr std::size_t most_batches =
    (most_points_along_edge * most_points_along_edge + batch_width - 1) / batch_width;

/// Rays through the points of a facet along the smoothed normals of its ply.
class NormalRays {
  public:
    /// @param corners, normals of the facet, m and of any length
    /// @param back, ahead      lengths of the rays against and along their direction, m
    NormalRays(const QuadratureRule& rule, const std::array<Vec3, 4>& corners,
               const std::array<Vec3, 4>& normals, double back, double ahead);

    /// Whether a ray may hit a facet in a box: false only if the box around all rays is apart from it.
    [[nodiscard]] bool may_reach(const Box& box);

    std::array<Rays, most_batches> batches;

  private:
    [[nodiscard]] Box stretch() const;

    std::size_t batch_count_;
    double back_, ahead_;
    std::optional<Box> stretch_;  ///< box around all rays, on demand: a test of one ray mostly decides
};

}  // namespace weavefront::contact
