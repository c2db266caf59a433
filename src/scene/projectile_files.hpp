#pragma once
/// @file
/// Surfaces of projectiles that a scene lists or takes from a file.

#include <array>
#include <vector>

#include "section.hpp"

namespace weavefront::scene {

/// `points` of a meridian, or those of `file`: (r, z) from the foremost point of the axis, which becomes the
/// origin, to the rearmost one, m. Empty where there are findings.
std::vector<std::array<double, 2>> profile_points(Section& section);

/// `points` and `triangles` of a closed surface, or those of the STL file `file`. Their foremost point on the
/// axis becomes the origin, m. Empty where there are findings.
/// @throws InputError naming the triangles that do not close the surface
Triangles mesh_triangles(Section& section);

}  // namespace weavefront::scene
