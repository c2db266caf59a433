#pragma once
/// @file
/// The shadow of a surface.

#include "weavefront/body/shape.hpp"

namespace weavefront::body {

/// Area of the shadow that parallel light along a direction of any length > 0 casts, m2. The shadow is summed
/// over 2000 stripes.
double shadow_area(const Outline& outline, const Vec3& direction);

}  // namespace weavefront::body
