#include <gtest/gtest.h>

#include <limits>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

constexpr double u = std::numeric_limits<double>::epsilon() / 2;  // unit roundoff

Vec3 momentum(const Simulation& simulation, const parallel::Communicator& comm, double projectile_mass) {
    const auto& nodes = simulation.model().nodes;
    const Vec3 fabric = sum_over_nodes(simulation, comm, Vec3(0, 0, 0),
                                       [&](std::size_t n) { return Vec3(nodes.mass[n] * nodes.v[n]); });
    return fabric + projectile_mass * simulation.model().projectiles.front().body.velocity();
}

/// Momentum without regard to signs: what rounding is relative to.
double rounded_momentum(const Simulation& simulation, const parallel::Communicator& comm,
                        double projectile_mass) {
    const auto& nodes = simulation.model().nodes;
    return sum_over_nodes(simulation, comm, 0.0,
                          [&](std::size_t n) { return nodes.mass[n] * nodes.v[n].norm(); }) +
           projectile_mass * simulation.model().projectiles.front().body.velocity().norm();
}

}  // namespace

// The integer forces of elements and contact add up to nothing, so the only error is that of v += dt f/m: a
// rounding of the product (three operations, on a change that is less than the velocities before and after)
// and one of the sum. Per step that is at most u (|v| + 3 |dv|) <= 7 u |v|max a node; the sum that this test
// takes adds u for each of its terms.
TEST(FreeFlight, KeepsTheMomentumOfTargetAndProjectile) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with({"target.plies.count=3", "projectile.position=[1 mm, 2 mm, -0.11 mm]",
                                   "projectile.velocity=[60 m/s, -30 m/s, 300 m/s]",
                                   "contact.projectile.friction=0.3", "contact.plies.friction=0.2"});
    Simulation simulation(scene, comm);
    const double mass = scene.projectiles.front().mass;
    const Vec3 before = momentum(simulation, comm, mass);
    double tolerance = static_cast<double>(simulation.model().global.nodes) * u * mass * 310;
    while (simulation.time() < 30e-6) {
        const double last = rounded_momentum(simulation, comm, mass);
        advance(simulation, 1);
        tolerance += 7 * u * std::max(last, rounded_momentum(simulation, comm, mass));
    }
    const Vec3 after = momentum(simulation, comm, mass);
    const double given = mass * (scene.projectiles.front().velocity[2] -
                                 simulation.model().projectiles.front().body.velocity().z());
    EXPECT_GT(given, 0.1 * before.z()) << "the target was hardly hit";
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(after[d], before[d], tolerance) << "direction " << d;
    EXPECT_LT(tolerance, 1e-11 * before.norm());
}

// Internal forces and those between plies are moment free at the positions where they act, up to the quantum
// q of the fixed point (the rounding of the kernel is less than a hundredth of it: q = 2^-44 of a reference
// force, u = 2^-53). An element rounds three corners by up to q/2 a component; a pair of facets up to seven,
// over a lever of at most two diagonals; a facet meets at most nine others. x moves along v, so the half step
// between them does not show in m x cross v: the integrator adds nothing but rounding, u of m |x| |v| for
// each of ten operations.
TEST(FreeFlight, KeepsTheAngularMomentumOfTheFabric) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with({"target.plies.count=2", "projectile=", "contact.projectile="});
    Simulation simulation(scene, comm);
    // Two plies that turn in opposite directions are thrown at each other.
    set_motion(
        simulation, [](const Vec3& x) { return x; },
        [](const Vec3& x) -> Vec3 {
            const double side = x.z() > 0 ? 1 : -1;
            return Vec3(0.2e4, 0.3e4, side * 1e4).cross(x) + Vec3(5, -3, -30 * side + 4e3 * x.x());
        });
    const auto& nodes = simulation.model().nodes;
    const auto angular = [&] {
        return sum_over_nodes(simulation, comm, Vec3(0, 0, 0), [&](std::size_t n) {
            return Vec3(nodes.mass[n] * nodes.x[n].cross(nodes.v[n]));
        });
    };
    const auto rounded = [&] {
        return sum_over_nodes(simulation, comm, 0.0, [&](std::size_t n) {
            return nodes.mass[n] * nodes.x[n].norm() * nodes.v[n].norm();
        });
    };
    advance(simulation, 1);
    const Vec3 before = angular();
    const double quantum = simulation.model().assembly.scale().quantum(),
                 diagonal = 2 * std::sqrt(2.0) * 2e-3;
    const double moment = static_cast<double>(simulation.model().global.elements) * std::sqrt(3.0) * quantum *
                          diagonal * (3 + 9 * 7 * 2);
    double tolerance = 0, largest_contact = 0;
    while (simulation.time() < 30e-6) {
        tolerance += moment * simulation.time_step() + 10 * u * rounded();
        simulation.advance_forces();
        largest_contact = std::max(largest_contact, simulation.balance().contact);
        simulation.integrate();
    }
    tolerance += static_cast<double>(simulation.model().global.nodes) * u * rounded();
    EXPECT_GT(largest_contact, 1e-2) << "J: the plies did not meet";
    const Vec3 after = angular();
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(after[d], before[d], tolerance) << "about axis " << d;
    EXPECT_LT(tolerance, 1e-6 * before.norm());
}

}  // namespace weavefront::solver::test
