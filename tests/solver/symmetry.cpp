#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

/// The balance every tenth step.
std::vector<Balance> history(const parallel::Communicator& comm, const std::string& symmetry, int steps) {
    Simulation simulation(
        scene_with({"target.plies.count=2", "target.size=[32 mm, 24 mm]", "target.edges={x: fixed, y: free}",
                    "target.mesh={center: 1 mm, edge: 3 mm, growth: 1.2}", "target.symmetry=" + symmetry}),
        comm);
    std::vector<Balance> rows;
    for (int n = 0; n <= steps; ++n) {
        simulation.advance_forces();
        if (n % 10 == 0) rows.push_back(simulation.balance());
        simulation.integrate();
    }
    return rows;
}

}  // namespace

// A mirrored element has the same forces but for rounding, and the fixed point rounds them to 2^-44 of a
// reference force that gives the lightest node about a tenth of a wave speed (800 m/s) a step. Over 800
// steps, all errors of one sign, velocities of up to 200 m/s differ by less than 800 * 800 * 2^-44 m/s
// = 3.6e-8 m/s, and with them energies by 2 * 3.6e-8/200 = 3.6e-10 of the initial one.
TEST(Symmetry, PartsOfTheTargetHaveTheHistoryOfTheWhole) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    constexpr int steps = 800;
    const auto full = history(comm, "[]", steps);
    const double initial = full[0].kinetic_projectile;
    ASSERT_LT(full.back().projectiles[0].velocity.z(), 0.8 * 200) << "m/s: the target was hardly hit";
    ASSERT_GT(full.back().contact, 1e-3 * initial);
    for (const std::string symmetry : {"[x]", "[y]", "[x, y]"}) {
        const auto part = history(comm, symmetry, steps);
        ASSERT_EQ(part.size(), full.size());
        for (std::size_t i = 0; i < full.size(); ++i) {
            SCOPED_TRACE(symmetry + ", row " + std::to_string(i));
            EXPECT_NEAR(part[i].time, full[i].time, 3.6e-10 * full[i].time);  // the step follows the strain
            EXPECT_NEAR(part[i].projectiles[0].velocity.z(), full[i].projectiles[0].velocity.z(), 3.6e-8);
            for (const auto column :
                 {&Balance::kinetic_fabric, &Balance::kinetic_projectile, &Balance::internal,
                  &Balance::hourglass, &Balance::contact, &Balance::friction})
                EXPECT_NEAR(part[i].*column, full[i].*column, 3.6e-10 * initial);
        }
    }
}

}  // namespace weavefront::solver::test
