#pragma once
/// @file
/// A small target with every part of the model but failure, for the tests of the solver to vary.

#include <string>
#include <vector>

#include "weavefront/scene/read.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver::test {

inline const std::string small_scene = R"(
fabrics:
  kevlar129:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}
    thickness: 0.2 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    lateral: {modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 35 deg, transition: 3 deg}
    friction: 0.11
    transverse_shear: 2.5 GPa
target:
  size: [24 mm, 24 mm]
  plies: {count: 1, fabric: kevlar129, spacing: 0.25 mm}
  mesh: {center: 2 mm}
  edges: {x: free, y: free}
projectile: {shape: sphere, diameter: 6 mm, mass: 0.5 g, velocity: [0, 0, 200 m/s]}
contact:
  spacing: 0.5 mm
  projectile: {}
  plies: {}
time: {end: 1 ms}
output: {interval: 1 ms, history: 1 ms}
)";

/// The scene with values put in place of its own, as `--set` does.
inline scene::Scene scene_with(const std::vector<std::string>& overrides) {
    return scene::parse_scene(small_scene, "small_scene", overrides);
}

inline void advance(Simulation& simulation, int steps) {
    for (int n = 0; n < steps; ++n) {
        simulation.advance_forces();
        simulation.integrate();
    }
}

/// Puts every node, ghosts included, at `position` and gives it `velocity`, functions of where it stands.
template <class Position, class Velocity>
void set_motion(Simulation& simulation, Position position, Velocity velocity) {
    auto& nodes = simulation.model().nodes;
    for (std::size_t n = 0; n < nodes.x.size(); ++n) {
        const Vec3 at = nodes.x[n];
        nodes.x[n] = position(at);
        nodes.v[n] = velocity(at);
    }
}

/// Sum over the nodes of all ranks, each counted once. @note Collective
template <class Value, class Term>
Value sum_over_nodes(const Simulation& simulation, const parallel::Communicator& comm, Value sum, Term term) {
    const auto& nodes = simulation.model().nodes;
    for (std::size_t n = 0; n < static_cast<std::size_t>(nodes.count); ++n)
        if (nodes.owned[n]) sum += term(n);
    constexpr int numbers = sizeof(Value) / sizeof(double);
    MPI_Allreduce(MPI_IN_PLACE, &sum, numbers, MPI_DOUBLE, MPI_SUM, comm.get());
    return sum;
}

}  // namespace weavefront::solver::test
