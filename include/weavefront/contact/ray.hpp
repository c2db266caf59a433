#pragma once
/// @file
/// Where the normals through contact points meet a facet.

#include <array>

#include "weavefront/contact/lanes.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// Lines through eight points.
struct Rays {
    VectorLanes origin;
    VectorLanes direction;  ///< unit
};

/// One line, in all lanes. @param direction unit
Rays one_ray(const Vec3& origin, const Vec3& direction);

/// What the lines meet.
struct RayHits {
    LaneMask hit;
    Lanes xi, eta;   ///< parent coordinates of the facet
    Lanes distance;  ///< along the direction, m; negative when the facet lies behind
};

/// Meets the bilinear facet, whose normal must not point against the direction of a line. A point on the edge
/// between two facets is found by at least one of them.
/// @param corners of the facet, m
RayHits intersect(const Rays& rays, const std::array<Vec3, 4>& corners);

}  // namespace weavefront::contact
