/// Several projectiles.

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "small_scene.hpp"
#include "weavefront/solver/outcome.hpp"

namespace weavefront::solver::test {

namespace {

const std::string
    left =
        "{shape: sphere, diameter: 6 mm, mass: 0.5 g, position: [-6 mm, 0, -0.11 mm], velocity: "
        "[0, 0, 200 m/s]}",
    right =
        "{shape: sphere, diameter: 6 mm, mass: 0.5 g, position: [6 mm, 0, -0.11 mm], velocity: "
        "[0, 0, 200 m/s]}",
    late =
        "{shape: cylinder, diameter: 4 mm, length: 5 mm, mass: 0.3 g, position: [5 mm, 3 mm, "
        "-0.5 mm], velocity: [40 m/s, 0, 300 m/s], orientation: {yaw: 10 deg}, spin: 1e4 rad/s, "
        "delay: 10 us}";

scene::Scene scene_of(const std::string& one, const std::string& other,
                      std::vector<std::string> overrides = {}) {
    overrides.emplace_back("projectile=");
    overrides.push_back("projectiles=[" + one + ", " + other + "]");
    return scene_with(overrides);
}

}  // namespace

// The target and the shots are their own mirror image about x = 0. Rounding is not, and contact that opens a
// step earlier makes more of it.
TEST(Projectiles, MirroredShotsStayMirrored) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_of(left, right), comm);
    while (simulation.time() < 60e-6) advance(simulation, 1);
    simulation.advance_forces();
    const auto balance = simulation.balance();
    const auto &a = balance.projectiles[0], &b = balance.projectiles[1];
    EXPECT_LT(a.velocity.z(), 0.9 * 200) << "m/s: the target was hardly hit";
    EXPECT_NEAR(a.velocity.z(), b.velocity.z(), 1e-6 * 200);
    EXPECT_NEAR(a.velocity.x(), -b.velocity.x(), 1e-6 * 200);
    EXPECT_NEAR(a.position.z(), b.position.z(), 1e-6 * 6e-3);
    EXPECT_LT(std::abs(balance.energy_error), 2e-3);
}

// Until the waves of the shots meet, each is the shot that hits alone. They are 12 mm apart, and the fastest
// wave goes 6.4 mm/us (sqrt(E1/rho) of the yarns, in elements of 1 mm). The time step is another one.
TEST(Projectiles, AShotFarFromTheOtherOneIsAShotAlone) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const std::vector<std::string> fine{"target.mesh.center=1 mm", "target.size=[40 mm, 24 mm]",
                                        "fabrics.kevlar129.elastic.viscosity=0 Pa s"};
    auto alone = fine;
    alone.emplace_back("projectile.position=[-6 mm, 0, -0.11 mm]");
    Simulation both(scene_of(left, right, fine), comm), one(scene_with(alone), comm);
    constexpr double end = 0.8e-6;  // s
    for (auto* simulation : {&both, &one}) {
        while (simulation->time() < end) advance(*simulation, 1);
        simulation->advance_forces();
    }
    const double lost = 200 - one.balance().projectiles[0].velocity.z();
    EXPECT_GT(lost, 0.3) << "m/s: the target was hardly hit";
    EXPECT_NEAR(200 - both.balance().projectiles[0].velocity.z(), lost, 0.03 * lost);
}

TEST(Projectiles, ALateOneFliesFreelyUntilItArrives) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_of(left, late);
    Simulation simulation(scene, comm);
    const Vec3 velocity(40, 0, 300), place(5e-3, 3e-3, -0.5e-3);
    double arrival = 0;
    while (simulation.time() < 30e-6) {
        simulation.advance_forces();
        const auto now = simulation.balance().projectiles[1];
        if (arrival == 0 && now.contact_force.norm() > 0) arrival = simulation.time();
        if (arrival == 0) {
            EXPECT_EQ(now.velocity, velocity);
            EXPECT_LT((now.position - (place + (simulation.time() - 10e-6) * velocity)).norm(), 1e-15);
        }
        simulation.integrate();
    }
    EXPECT_GT(arrival, 10e-6);  // s
    EXPECT_LT(arrival, 15e-6);
    EXPECT_LT(simulation.shots()[0].last_touched, 30e-6);
    EXPECT_GT(simulation.shots()[1].last_touched, arrival);
}

// As for one projectile: FreeFlight.KeepsTheMomentumOfTargetAndProjectile derives the tolerance.
TEST(Projectiles, GiveTheTargetWhatTheyLose) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_of(left, late, {"target.plies.count=2", "contact.projectile.friction=0.3"}),
                          comm);
    const auto momentum = [&](bool absolute) {
        const auto& nodes = simulation.model().nodes;
        Vec3 sum = sum_over_nodes(simulation, comm, Vec3(0, 0, 0), [&](std::size_t n) {
            const Vec3 own = nodes.mass[n] * nodes.v[n];
            return absolute ? Vec3(own.cwiseAbs()) : own;
        });
        for (const auto& projectile : simulation.model().projectiles)
            sum += projectile.body.mass() *
                   (absolute ? Vec3(projectile.body.velocity().cwiseAbs()) : projectile.body.velocity());
        return sum;
    };
    const Vec3 before = momentum(false);
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    double tolerance = static_cast<double>(simulation.model().global.nodes) * u * before.norm();
    double largest_error = 0;
    while (simulation.time() < 30e-6) {
        const double last = momentum(true).norm();
        simulation.advance_forces();
        largest_error = std::max(largest_error, std::abs(simulation.balance().energy_error));
        simulation.integrate();
        tolerance += 7 * u * std::max(last, momentum(true).norm());
    }
    const Vec3 after = momentum(false);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(after[d], before[d], tolerance) << "direction " << d;
    EXPECT_LT(tolerance, 1e-11 * before.norm());
    for (const auto& [initial, now] : {std::pair(200, 0), std::pair(300, 1)})
        EXPECT_LT(simulation.model().projectiles[static_cast<std::size_t>(now)].body.velocity().z(),
                  0.95 * initial)
            << "m/s: it hardly hit";
    EXPECT_LT(largest_error, 2e-3);
}

// The hole of the first one is no hole of the second one, which flies past the corner of the target.
TEST(Projectiles, EachHasItsOwnOutcome) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const std::string fast =
                          "{shape: sphere, diameter: 6 mm, mass: 0.5 g, position: [-6 mm, 0, -0.11 mm], "
                          "velocity: [0, 0, 800 m/s]}",
                      beside =
                          "{shape: sphere, diameter: 1 mm, mass: 4 mg, position: [11.9 mm, 11.9 mm, -0.2 "
                          "mm], velocity: [300 m/s, 300 m/s, 600 m/s], delay: 10 us}";
    Simulation simulation(
        scene_of(fast, beside, {"fabrics.kevlar129.failure={static_strain: 0.01, hooke_strain: 0.01}"}),
        comm);
    while (simulation.time() < 30e-6) advance(simulation, 1);
    EXPECT_EQ(outcome_of(simulation.shots()[0]).verdict, Verdict::perforated);
    EXPECT_EQ(outcome_of(simulation.shots()[1]).verdict, Verdict::passed);
}

TEST(Projectiles, ThatFlyIntoEachOtherAreNoted) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const std::string fast =
        "{shape: sphere, diameter: 6 mm, mass: 0.5 g, position: [-6 mm, 0, -20 mm], "
        "velocity: [0, 0, 900 m/s]}";
    Simulation apart(scene_of(left, right), comm), hit(scene_of(left, fast), comm);
    for (auto* simulation : {&apart, &hit})
        while (simulation->time() < 25e-6) advance(*simulation, 1);
    EXPECT_EQ(apart.projectile_overlap().depth, 0);
    EXPECT_GT(hit.projectile_overlap().depth, 1e-3);  // m
    EXPECT_EQ(hit.projectile_overlap().second, 1);
}

}  // namespace weavefront::solver::test
