#pragma once
/// @file
/// Positions and velocities of the nodes in one step.

#include <span>

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// Motion of the local nodes, ghosts included. A node has moved by `dt` times its velocity since the last
/// step.
struct NodalMotion {
    std::span<const Vec3> x;  ///< present positions, m
    std::span<const Vec3> v;  ///< velocities over the last step, m/s
    double dt;                ///< length of the last step, s
};

}  // namespace weavefront::contact
