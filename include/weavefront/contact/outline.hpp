#pragma once
/// @file
/// How far apart facets are at least.

#include <array>

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// A facet seen from others.
class Outline {
  public:
    /// @param corners of the facet, m
    explicit Outline(const std::array<Vec3, 4>& corners);

    /// A bound from below of the distance to another facet, m, negative when none was found. It is the widest gap that
    /// planes leave across one of these: an axis, the normal of either facet, the line between their nearest corners.
    /// @param enough stops looking when a gap as wide is found, m
    [[nodiscard]] double distance_to(const Outline& other, double enough) const;

  private:
    [[nodiscard]] Vec3 normal() const;
    [[nodiscard]] double gap_along(const Vec3& axis, const Outline& other) const;
    [[nodiscard]] Vec3 between_nearest_corners(const Outline& other) const;

    std::array<Vec3, 4> corners_;
    Vec3 low_, high_;
};

}  // namespace weavefront::contact
