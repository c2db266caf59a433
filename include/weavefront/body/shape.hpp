#pragma once
/// @file
/// The surface of a rigid body.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "weavefront/body/depth.hpp"
#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::body {

/// Face of a shape through which a point of the fabric entered; 0: none. A point keeps its face until it has
/// left, so the contact normal does not jump at an edge.
using Face = std::int32_t;

/// Smallest box along the axes of a body that holds its surface, m.
struct Bounds {
    Vec3 low, high;
};

/// Mass properties of a body of uniform density.
struct MassProperties {
    double volume;            ///< m3
    Vec3 centroid;            ///< m
    Eigen::Matrix3d inertia;  ///< about the centroid, per unit mass, m2
};

/// A surface for pictures.
struct Outline {
    std::vector<Vec3> points;                        ///< m
    std::vector<std::array<std::int64_t, 4>> quads;  ///< indices into `points`; a triangle repeats its last
};

/// Closed surface in the axes of a rigid body. The origin is the foremost point of the nose on the axis; +z
/// points out of the nose.
class Shape {
  public:
    virtual ~Shape() = default;

    /// Depth of a point in the shape inflated by `offset`, half the thickness of the fabric.
    /// @param point  m
    /// @param offset m, >= 0
    /// @param face   memory of the point, updated
    /// @return       none outside
    [[nodiscard]] virtual std::optional<Depth> depth(const Vec3& point, double offset, Face& face) const = 0;

    /// Bounds of the shape, not inflated, m.
    [[nodiscard]] virtual Bounds bounds() const = 0;

    /// The largest distance of a point of the shape, not inflated, from the z axis, m.
    [[nodiscard]] virtual double radius() const = 0;

    /// Volume, centroid and inertia at uniform density.
    [[nodiscard]] virtual MassProperties mass_properties() const = 0;

    /// Area of the shadow that parallel light casts, m2.
    /// @param direction of the light, of any length > 0
    [[nodiscard]] virtual double presented_area(const Vec3& direction) const = 0;

    /// The surface as pictures show it.
    [[nodiscard]] virtual Outline outline() const = 0;
};

/// The shape that a scene describes.
std::unique_ptr<const Shape> make_shape(const scene::Projectile& projectile);

}  // namespace weavefront::body
