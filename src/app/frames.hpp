#pragma once
/// @file
/// From the solver's state to the frames of results.vtkhdf.

#include <vector>

#include "projectile_surface.hpp"
#include "weavefront/io/rows.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::app {

/// The part of the topology that this rank owns.
io::Topology topology_of(const solver::Simulation& simulation);

/// The present state, with the fields that the scene asks for, velocities as of this time; between
/// advance_forces and integrate. Numbers that are not finite, as a run stopped by the guard may hold, stay
/// so: the file refuses them.
/// @param surfaces of the projectiles, each in its axes
/// @note Collective
io::Frame frame_of(solver::Simulation& simulation, const ProjectileSurfaces& surfaces,
                   const std::vector<scene::Field>& fields);

}  // namespace weavefront::app
