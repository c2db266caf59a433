#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

constexpr double u = std::numeric_limits<double>::epsilon() / 2;  // unit roundoff

// It strikes with its rim, beside the middle of the target, and spins.
const std::string inclined =
    "projectile={shape: cylinder, diameter: 5 mm, edge_radius: 0.3 mm, length: 7 mm, mass: 0.9 g, "
    "position: [2 mm, -1 mm, -2 mm], velocity: [40 m/s, -20 m/s, 200 m/s], "
    "orientation: {yaw: 20 deg, pitch: 10 deg}, spin: 30000 rpm}";

// Each node of the fabric takes the moment of its integer force, and the projectile those of its facets, in
// its own fixed point. What is lost per step is a quantum of force over the lever of each node of a facet and
// a quantum of moment for each facet. Friction does so once more. The rest is the rounding of ten operations.
TEST(TurningProjectile, KeepsTheAngularMomentumOfTargetAndProjectile) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"target.plies.count=2", inclined, "contact.projectile.friction=0.3"}),
                          comm);
    const auto& nodes = simulation.model().nodes;
    const auto& projectile = simulation.model().projectiles.front().body;
    const auto angular = [&] {
        const Vec3 fabric = sum_over_nodes(simulation, comm, Vec3(0, 0, 0), [&](std::size_t n) {
            return Vec3(nodes.mass[n] * nodes.x[n].cross(nodes.v[n]));
        });
        return Vec3(fabric + projectile.mass() * projectile.centre().cross(projectile.velocity()) +
                    projectile.angular_momentum());
    };
    const auto rounded = [&] {
        return sum_over_nodes(
                   simulation, comm, 0.0,
                   [&](std::size_t n) { return nodes.mass[n] * nodes.x[n].norm() * nodes.v[n].norm(); }) +
               projectile.mass() * projectile.centre().norm() * projectile.velocity().norm() +
               projectile.angular_momentum().norm();
    };
    advance(simulation, 1);
    const Vec3 before = angular(), alone = projectile.angular_momentum();
    const double quantum = simulation.model().assembly.scale().quantum(), lever = std::sqrt(2.0) * 14e-3;
    const double moment = static_cast<double>(simulation.model().global.elements) * std::sqrt(3.0) * quantum *
                          lever * (3 + 9 * 7 * 2 + 7);
    double tolerance = 0;
    while (simulation.time() < 60e-6) {
        tolerance += moment * simulation.time_step() + 10 * u * rounded();
        advance(simulation, 1);
    }
    const Vec3 after = angular();
    EXPECT_GT((projectile.angular_momentum() - alone).norm(), 0.3 * alone.norm()) << "it was hardly turned";
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(after[d], before[d], tolerance) << "about axis " << d;
    EXPECT_LT(tolerance, 1e-5 * alone.norm());
}

TEST(TurningProjectile, ClosesTheEnergyLedger) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"target.plies.count=2", inclined}), comm);
    double largest = 0;
    while (simulation.time() < 60e-6) {
        simulation.advance_forces();
        const auto balance = simulation.balance();
        largest = std::max(largest, std::abs(balance.energy_error));
        ASSERT_TRUE(balance.projectiles[0].rotation.has_value());
        simulation.integrate();
    }
    EXPECT_LT(largest, 2e-3);
}

// Friction on the nose slows the spin down.
TEST(TurningProjectile, LosesSpinToFriction) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const std::string spinning =
        "projectile={shape: cylinder, diameter: 5 mm, edge_radius: 0.3 mm, length: 7 mm, mass: 0.9 g, "
        "velocity: [0, 0, 200 m/s], spin: 300000 rpm}";
    const auto spin_after = [&](const std::vector<std::string>& overrides) {
        auto all = overrides;
        all.insert(all.end(), {"target.plies.count=2", spinning});
        Simulation simulation(scene_with(all), comm);
        while (simulation.time() < 20e-6) advance(simulation, 1);
        return simulation.model().projectiles.front().body.angular_velocity().z();
    };
    const double before = 300000 * 2 * std::numbers::pi / 60, without = spin_after({});
    EXPECT_NEAR(without, before, 1e-3 * before);
    EXPECT_LT(spin_after({"contact.projectile.friction=0.3"}), 0.999 * without);
}

TEST(TurningProjectile, KeepsItsAttitudeWhereItsRotationIsFixed) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(
        scene_with({"target.plies.count=2", inclined, "projectile.spin=", "projectile.fixed=rotation"}),
        comm);
    const auto start = simulation.model().projectiles.front().body.attitude().quaternion();
    advance(simulation, 200);
    EXPECT_EQ(simulation.model().projectiles.front().body.attitude().quaternion(), start);
    simulation.advance_forces();
    EXPECT_FALSE(simulation.balance().projectiles[0].rotation.has_value());
    EXPECT_GT(simulation.balance().projectiles[0].contact_force.norm(), 0);
}

/// Angular velocity after a shot of 40 us at a target with these planes of symmetry.
Vec3 turned(const std::string& symmetry, const parallel::Communicator& comm) {
    Simulation simulation(
        scene_with({"target.plies.count=2", "target.symmetry=" + symmetry,
                    "projectile={shape: cylinder, diameter: 5 mm, length: 7 mm, mass: 0.9 g, "
                    "velocity: [0, 20 m/s, 200 m/s], orientation: {pitch: 15 deg}}"}),
        comm);
    while (simulation.time() < 40e-6) advance(simulation, 1);
    return simulation.model().projectiles.front().body.angular_velocity();
}

TEST(TurningProjectile, TurnsInAPlaneOfSymmetryAsWithoutIt) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const Vec3 whole = turned("[]", comm), half = turned("[x]", comm);
    EXPECT_GT(std::abs(whole.x()), 500);
    // Of the whole target, the two halves round differently.
    EXPECT_LT((half - whole).norm(), 1e-6 * whole.norm());
    EXPECT_EQ(half.y(), 0);
    EXPECT_EQ(half.z(), 0);
}

}  // namespace
}  // namespace weavefront::solver::test
