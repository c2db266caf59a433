#pragma once
/// @file
/// The rigid frame behind the target and its surface.

#include <array>
#include <optional>

#include "weavefront/body/depth.hpp"
#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// Straight bars on both sides of an opening, or a ring around a round one, with rounded inner edges. They
/// extend without end outwards and along +z. The shape is inflated by half the thickness of the fabric.
class FrameShape {
  public:
    /// @param top    height of the surface on which the last ply rests, m
    /// @param offset distance from the surface at which the fabric's mid-surface touches it, m
    FrameShape(const scene::Frame& frame, double top, double offset);

    /// Depth of a point; none outside. @param point m
    [[nodiscard]] std::optional<body::Depth> depth(const Vec3& point) const;
    /// Depth of a point in one bar; none outside.
    /// @param outward from the opening into the bar, of unit length: along x or y, or of a ring
    /// `away_from_axis`
    [[nodiscard]] std::optional<body::Depth> depth_in_bar(const Vec3& point, const Vec3& outward) const;
    /// Direction from the middle of the opening to a point, along x and y and of unit length; x in the
    /// middle.
    [[nodiscard]] static Vec3 away_from_axis(const Vec3& point);

    /// Whether a box may hold a point inside a bar. @param low, high corners, m
    [[nodiscard]] bool may_touch(const Vec3& low, const Vec3& high) const;

  private:
    std::array<std::optional<double>, 2> half_opening_;  // of the inflated bars, m
    std::optional<double> radius_;                       // of the inflated ring, m
    double top_, edge_;
};

}  // namespace weavefront::contact
