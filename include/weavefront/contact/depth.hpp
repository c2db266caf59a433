#pragma once
/// @file
/// How far a point lies inside a rigid body.

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// Depth of a point below a surface.
struct Depth {
    double depth = 0;  ///< m, > 0 inside
    Vec3 normal;       ///< outward, unit
};

}  // namespace weavefront::contact
