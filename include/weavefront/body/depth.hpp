#pragma once
/// @file
/// How far a point lies inside a rigid body.

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::body {

/// Depth of a point below a surface.
struct Depth {
    double depth = 0;   ///< m, > 0 inside
    Vec3 normal;        ///< outward, unit
    double radius = 0;  ///< of curvature of a round body, m; 0: edge or flat face
};

}  // namespace weavefront::body
