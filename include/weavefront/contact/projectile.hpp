#pragma once
/// @file
/// The rigid projectile and its surface.

#include <cstdint>
#include <optional>

#include "weavefront/contact/depth.hpp"
#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// The side through which a point of the fabric entered the projectile. A point keeps its side until it has
/// left, so the contact normal does not jump at a sharp edge.
enum class Side : std::uint8_t { none, front, side, rear };

/// Sphere, or cylinder about z with rounded edges, inflated by half the thickness of the fabric. The nose
/// points to +z.
class ProjectileShape {
  public:
    /// @param offset distance from the projectile's surface at which the fabric's mid-surface touches it, m
    ProjectileShape(const scene::Projectile& projectile, double offset);

    /// Depth of a point relative to the nose of the (not inflated) projectile.
    /// @param point position minus that of the nose, m
    /// @param side  memory of the point, updated
    /// @return      none outside
    [[nodiscard]] std::optional<Depth> depth(const Vec3& point, Side& side) const;

    /// Radius of the inflated shape about its axis, m.
    [[nodiscard]] double radius() const { return radius_; }
    /// Extent of the inflated shape along z, relative to the nose, m.
    [[nodiscard]] double front() const { return front_; }
    [[nodiscard]] double rear() const { return rear_; }

  private:
    [[nodiscard]] std::optional<Depth> sphere_depth(const Vec3& point) const;
    /// Distance along z of the rounded face behind its plane at a radius, m.
    [[nodiscard]] double rim_drop(double radius) const;
    /// Depth below the face looking along the axis; `direction` +1 for the front, -1 for the rear.
    [[nodiscard]] Depth face_depth(const Vec3& point, double radius, double axial, double direction) const;
    [[nodiscard]] Depth side_depth(const Vec3& point, double radius) const;

    bool sphere_;
    double radius_, edge_, front_, rear_;
};

}  // namespace weavefront::contact
