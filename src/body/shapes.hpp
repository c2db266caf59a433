#pragma once
/// @file
/// The shapes that consist of one surface of revolution or of triangles, each in a file of its own.

#include <memory>

#include "weavefront/body/shape.hpp"

namespace weavefront::body {

using ShapePointer = std::unique_ptr<const Shape>;

/// Cylinder with a hemispherical nose.
ShapePointer make_hemisphere(const scene::Projectile& projectile);

/// Cylinder with a conical nose, sharp or rounded by a sphere.
ShapePointer make_cone(const scene::Projectile& projectile);

/// Cylinder with the nose of a cone that a face cuts off.
ShapePointer make_truncated_cone(const scene::Projectile& projectile);

/// Cylinder with a tangent ogive, sharp or rounded by a sphere.
ShapePointer make_ogive(const scene::Projectile& projectile);

/// Body of revolution with straight lines between the points of its meridian.
ShapePointer make_profile(const scene::Projectile& projectile);

/// Box about the z axis.
ShapePointer make_box(const scene::Projectile& projectile);

/// Part of a ring about an axis parallel to y, as of a blade. The middle of its outer side is the nose.
ShapePointer make_ring_segment(const scene::Projectile& projectile);

/// Cylinder with a chisel nose: a face along y between two flats.
ShapePointer make_fsp(const scene::Projectile& projectile);

/// Surface of the triangles that the scene lists.
ShapePointer make_mesh(const scene::Projectile& projectile);

}  // namespace weavefront::body
