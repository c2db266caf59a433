#pragma once
/// @file
/// The projectile as pictures show it.

#include "weavefront/io/rows.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// Quads of the projectile's surface relative to its nose; empty without a projectile.
io::Surface projectile_surface(const scene::Scene& scene);

}  // namespace weavefront::app
