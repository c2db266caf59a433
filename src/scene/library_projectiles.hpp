#pragma once
/// @file
/// Projectiles that are taken from the library.

#include "document.hpp"
#include "findings.hpp"

namespace weavefront::scene {

/// Replaces the key `standard` of each projectile by the values of that projectile. Values of the scene come
/// before those of the library.
void insert_standard_projectiles(Value& scene, Findings& findings);

}  // namespace weavefront::scene
