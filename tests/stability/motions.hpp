#pragma once
/// @file
/// How the cases without a projectile begin: what scenes have no words for.

#include <functional>

#include "weavefront/solver/simulation.hpp"

namespace weavefront::stability {

using Prepare = std::function<void(solver::Simulation&)>;

/// The fabric moves with v = (rate_x x, rate_y y, 0). @param rate_x, rate_y 1/s @param roughness of the plies
/// along z, m
Prepare stretching(double rate_x, double rate_y, double roughness = 0);

/// A clamped panel whose middle is driven together along x: v_x = -speed sin(2 pi x/length), 0 at the edges.
/// @param speed m/s @param length of the panel, m @param roughness of the plies along z, m
Prepare crumpling(double speed, double length, double roughness);

/// One fill yarn of the first ply is broken over eight elements in a row through the middle of the model.
Prepare broken_yarn();

}  // namespace weavefront::stability
