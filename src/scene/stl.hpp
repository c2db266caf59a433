#pragma once
/// @file
/// Surfaces of triangles.

#include <string>
#include <string_view>

#include "weavefront/scene/scene.hpp"

namespace weavefront::scene {

/// Triangles of a surface may be so many: they and their points are 120000 values of the resolved scene.
inline constexpr std::size_t most_triangles = 20'000;

/// Reads an STL file, ASCII or binary. Corners of the same coordinates become one point.
/// @param name of the file, for messages
/// @throws InputError where it is no STL file
Triangles parse_stl(std::string_view bytes, const std::string& name);

/// Whether a surface is closed, its triangles have an area and all look outward.
/// @param name of the surface, for messages
/// @throws InputError naming each bad triangle by its number, from 1
void require_closed(const Triangles& surface, const std::string& name);

/// Moves a closed surface along z, so its foremost point on the z axis becomes the origin.
/// @throws InputError where the axis misses it
void move_nose_to_origin(Triangles& surface, const std::string& name);

/// Whether the points of a surface lie mirrored on both sides of a plane through the origin, within a
/// millionth of its size. @param axis 0: the plane x = 0, 1: y = 0
bool is_symmetric(const Triangles& surface, std::size_t axis);

}  // namespace weavefront::scene
