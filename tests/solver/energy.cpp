#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

constexpr double speed = 10;  // m/s

/// Largest closure error of a short impact.
double closure_error(const parallel::Communicator& comm, const std::string& safety) {
    Simulation simulation(
        scene_with({"target.plies.count=2", "target.symmetry=[x, y]", "time.safety=" + safety}), comm);
    double largest = 0;
    while (simulation.time() < 25e-6) {
        simulation.advance_forces();
        largest = std::max(largest, std::abs(simulation.balance().energy_error));
        simulation.integrate();
    }
    return largest;
}

}  // namespace

TEST(Energy, ClosureErrorFallsWithTheStep) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const double coarse = closure_error(comm, "0.8"), middle = closure_error(comm, "0.4"),
                 fine = closure_error(comm, "0.2");
    EXPECT_LT(coarse, 1e-5);
    EXPECT_NEAR(coarse / middle, 4, 0.5);
    EXPECT_NEAR(middle / fine, 4, 0.5);
}

// A fabric that flies freely loses its velocity by dv/dt = -c v. The central difference multiplies v by (1 -
// d)/(1 + d) a step, d = c dt/2, whose logarithm is -c dt (1 + (c dt)^2/12 + ...): second order, with a known
// constant.
TEST(Damping, SlowsAFlyingFabricToSecondOrder) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    constexpr double c = 2e5;  // 1/s
    for (const std::string safety : {"0.8", "0.4"}) {
        Simulation simulation(
            scene_with({"projectile=", "contact=", "damping=2e5 1/s", "time.safety=" + safety}), comm);
        set_motion(
            simulation, [](const Vec3& x) { return x; }, [](const Vec3&) { return Vec3(0, 0, speed); });
        advance(simulation, 1);
        simulation.advance_forces();
        // The trapezoid of the ledger begins with the first whole step.
        const double initial = simulation.balance().total(), dt = simulation.time_step();
        simulation.integrate();
        advance(simulation, 38);
        // 40 steps done: the velocity is that of time 39.5 dt, the first half step included.
        const double time = simulation.time() - dt / 2, exact = speed * std::exp(-c * time);
        const double error = c * time * (c * dt) * (c * dt) / 12;
        const double found = 1 - simulation.model().nodes.v[0].z() / exact;
        EXPECT_NEAR(found, error, 0.05 * error) << "safety " << safety;
        simulation.advance_forces();
        const auto balance = simulation.balance();
        EXPECT_LT(balance.kinetic_fabric, 0.5 * initial);
        // Each of some 200 nodes rounds its work to 2^-44 of a joule in each of 40 steps.
        EXPECT_NEAR(balance.total(), initial, 200 * 40 * 0x1p-44);
    }
}

}  // namespace weavefront::solver::test
