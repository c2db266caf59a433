#pragma once
/// @file
/// Intersections of rays with a bilinear facet.

#include <array>

#include "weavefront/mesh/vec3.hpp"
#include "weavefront/simd/lanes.hpp"

namespace weavefront::contact {

using namespace simd;

/// Rays of a batch of points.
struct Rays {
    VectorLanes origin;
    VectorLanes direction;  ///< unit
};

/// One ray in all lanes. @param origin m @param direction unit
Rays one_ray(const Vec3& origin, const Vec3& direction);

/// Intersections of a batch of rays with one facet.
struct RayHits {
    LaneMask hit;
    Lanes xi, eta;   ///< parent coordinates of the facet
    Lanes distance;  ///< along the direction, m; negative when the facet lies behind
};

/// Intersects rays with a bilinear facet. A facet whose normal points against a ray is not hit. A point on
/// the edge of two facets is hit on at least one of them.
/// @param corners of the facet, m
RayHits intersect(const Rays& rays, const std::array<Vec3, 4>& corners);

}  // namespace weavefront::contact
