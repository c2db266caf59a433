#include <gtest/gtest.h>

#include "small_scene.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::solver::test {

namespace {

/// The balance after an impact of 20 us by a projectile of a mass.
Balance struck_by(const std::string& mass, const parallel::Communicator& comm, bool* touched = nullptr) {
    Simulation simulation(scene_with({"target.edges={x: fixed, y: fixed}", "projectile.velocity.2=20 m/s",
                                      "projectile.mass=" + mass}),
                          comm);
    while (simulation.time() < 20e-6) {
        simulation.advance_forces();
        simulation.integrate();
    }
    simulation.advance_forces();
    if (touched) *touched = simulation.shots().front().touched;
    return simulation.balance();
}

}  // namespace

// It moves as if prescribed: what the fabric takes does not depend on its mass, nor does what the ledger
// resolves.
TEST(HeavyProjectile, HandsOverWhatItsMotionMakesTheFabricTake) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    bool touched = false;
    const auto heavy = struck_by("1e6 kg", comm, &touched), less = struck_by("1e2 kg", comm);
    EXPECT_TRUE(touched);
    EXPECT_GT(heavy.internal, 0);
    EXPECT_NEAR(heavy.internal / less.internal, 1, 1e-4);
    EXPECT_NEAR(heavy.kinetic_fabric / less.kinetic_fabric, 1, 1e-4);
    EXPECT_NEAR(heavy.contact / less.contact, 1, 1e-2);
    EXPECT_NEAR(heavy.transferred_energy / less.transferred_energy, 1, 1e-4)
        << "its own energy is no part of it";
    EXPECT_LT(std::abs(heavy.closure_error), 1e-3);
}

TEST(Guard, StopsARunInWhichYarnsFrictionOrContactGiveEnergyFromNowhere) {
    Balance balance;
    balance.transferred_energy = 10;
    EXPECT_NO_THROW(require_balance(balance, 0.05, 1));
    for (double Balance::*energy : {&Balance::internal, &Balance::friction, &Balance::contact}) {
        auto bad = balance;
        bad.*energy = -0.4;
        EXPECT_NO_THROW(require_balance(bad, 0.05, 1));
        bad.*energy = -0.6;
        EXPECT_THROW(require_balance(bad, 0.05, 1), GuardStop);
    }
    balance.contact_friction = -0.4;
    EXPECT_NO_THROW(require_balance(balance, 0.05, 1));
    balance.contact_friction = -0.6;
    EXPECT_THROW(require_balance(balance, 0.05, 1), GuardStop);
}

}  // namespace weavefront::solver::test
