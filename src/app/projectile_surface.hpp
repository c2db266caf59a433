#pragma once
/// @file
/// Projectiles as pictures show them.

#include "weavefront/io/rows.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// Quads of the surfaces of all projectiles, each relative to its nose; empty without a projectile.
struct ProjectileSurfaces {
    io::Surface all;
    std::vector<std::size_t> points, quads;  ///< of each projectile, how many
};

ProjectileSurfaces projectile_surfaces(const scene::Scene& scene);

}  // namespace weavefront::app
