#pragma once
/// @file
/// The vector of positions, velocities and forces.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace weavefront {

using Vec3 = Eigen::Vector3d;

}  // namespace weavefront
