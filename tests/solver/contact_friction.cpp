/// Friction of contact in the ledger.

#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

/// A glancing shot at two plies on a frame, with friction of every contact.
const std::vector<std::string> glancing{"target.plies.count=2",
                                        "target.edges={x: fixed, y: frame}",
                                        "target.frame={opening: {y: 16 mm}, edge_radius: 0.5 mm}",
                                        "projectile.velocity=[150 m/s, 40 m/s, 200 m/s]",
                                        "contact.projectile.friction={static: 0.3, kinetic: 0.2}",
                                        "contact.plies.friction=0.2",
                                        "contact.frame.friction=0.1"};

TEST(ContactFriction, ClosesTheLedgerAndNeverGivesEnergy) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with(glancing), comm);
    double error = 0, lowest = 0, last = 0;
    while (simulation.time() < 60e-6) {
        simulation.advance_forces();
        const auto balance = simulation.balance();
        ASSERT_TRUE(balance.contact_friction.has_value());
        error = std::max(error, std::abs(balance.energy_error));
        last = *balance.contact_friction;
        lowest = std::min(lowest, last);
        simulation.integrate();
    }
    EXPECT_LT(error, 2e-3);
    EXPECT_GT(last, 0.01);  // J, of the 15 J of the projectile
    EXPECT_GE(lowest, -1e-6 * last);
}

TEST(ContactFriction, HasNoColumnWithoutFriction) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const std::vector<std::vector<std::string>> scenes{
        {}, {"contact.plies.friction=0.3"}, {"contact.projectile.friction={static: 0}"}};  // of a single ply
    for (const auto& overrides : scenes) {
        Simulation simulation(scene_with(overrides), comm);
        simulation.advance_forces();
        EXPECT_FALSE(simulation.has_contact_friction());
        EXPECT_FALSE(simulation.balance().contact_friction.has_value());
    }
}

TEST(ContactFriction, HoldsTheProjectileBackAlongThePly) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto speed_along = [&](const std::string& friction) {
        Simulation simulation(
            scene_with({"projectile.velocity=[150 m/s, 0, 100 m/s]", "projectile.fixed=rotation",
                        "contact.projectile.friction=" + friction}),
            comm);
        while (simulation.time() < 30e-6) advance(simulation, 1);
        return simulation.model().projectiles.front().body.velocity().x();
    };
    const double without = speed_along("0"), with = speed_along("0.3");
    EXPECT_LT(with, without - 0.3);  // m/s
}

}  // namespace
}  // namespace weavefront::solver::test
