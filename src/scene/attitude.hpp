#pragma once
/// @file
/// Attitudes as unit quaternions w, x, y, z. A product turns by its right factor first.

#include <array>

namespace weavefront::scene {

using Quaternion = std::array<double, 4>;

Quaternion product(const Quaternion& a, const Quaternion& b);

/// @param axis  of any length > 0 @param angle rad
Quaternion about(const std::array<double, 3>& axis, double angle);

/// Of length 1. One that is so already to rounding keeps its bits.
Quaternion normalized(const Quaternion& q);

/// Where it turns an axis of the body (0 x, 1 y, 2 z).
std::array<double, 3> turned_axis(const Quaternion& q, std::size_t axis);

}  // namespace weavefront::scene
