#include "weavefront/solver/outcome.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

struct Run {
    Outcome outcome;
    std::vector<std::optional<Passage>> passages;
    double settled_at = 0;            ///< s; 0: never
    double deflection = 0, peak = 0;  ///< of the back face, then and until then, m
};

/// Computes to a time. @param end s
Run compute(const std::vector<std::string>& overrides, double end, const parallel::Communicator& comm) {
    Simulation simulation(scene_with(overrides), comm);
    Run run;
    while (simulation.time() < end && run.settled_at == 0) {
        for (int n = 0; n < 10; ++n) {
            simulation.advance_forces();
            if (n != 9) {
                simulation.integrate();
                continue;
            }
            const auto balance = simulation.record_balance();
            run.deflection = balance.back_face_deflection;
            run.peak = std::max(run.peak, run.deflection);
            if (is_settled(simulation, balance)) run.settled_at = simulation.time();
            simulation.integrate();
        }
    }
    run.outcome = outcome_of(simulation.shots().front());
    run.passages = simulation.shots().front().passages.plies();
    return run;
}

const std::string held = "target.edges={x: fixed, y: fixed}", two_plies = "target.plies.count=2";

}  // namespace

TEST(Outcome, IsStoppedWhenTheProjectileTurnsBack) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto run = compute({held, two_plies, "projectile.velocity.2=50 m/s"}, 1e-3, comm);
    EXPECT_EQ(run.outcome.verdict, Verdict::stopped);
    EXPECT_EQ(run.outcome.plies_perforated, 0);
    ASSERT_TRUE(run.outcome.decided_at);
    EXPECT_GT(run.settled_at, *run.outcome.decided_at);
    for (const auto& passage : run.passages) EXPECT_FALSE(passage);
}

TEST(Outcome, IsPerforatedWhenAllPliesHaveAHole) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto run =
        compute({held, two_plies, "fabrics.kevlar129.failure={static_strain: 1 %, hooke_strain: 1 %}",
                 "projectile.velocity.2=400 m/s"},
                1e-4, comm);
    EXPECT_EQ(run.outcome.verdict, Verdict::perforated);
    EXPECT_EQ(run.outcome.plies_perforated, 2);
    EXPECT_GT(run.settled_at, *run.outcome.decided_at);
    EXPECT_LT(run.deflection, run.peak) << "a perforated target goes on dishing";
    for (const auto& passage : run.passages) {
        ASSERT_TRUE(passage);
        EXPECT_EQ(passage->way, Way::hole);
    }
}

// Nodes are farther apart than the sphere is wide, and it passes between them.
TEST(Outcome, TellsWholeFabricThatTheProjectilePassed) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto run =
        compute({held, two_plies, "target.mesh.center=12 mm", "contact.spacing=nodes",
                 "projectile.position=[0, 0, -12.1 mm]", "projectile.velocity=[100 m/s, 100 m/s, 200 m/s]"},
                1e-4, comm);
    EXPECT_EQ(run.outcome.verdict, Verdict::passed);
    EXPECT_EQ(run.outcome.plies_perforated, 0);
    for (std::size_t p = 0; p < 2; ++p) {
        ASSERT_TRUE(run.passages[p]);
        EXPECT_EQ(run.passages[p]->way, Way::whole_fabric);
        EXPECT_EQ(run.passages[p]->element, static_cast<std::int64_t>(4 * p + 3))
            << "the one around (6, 6) mm";
    }
}

// It leaves the panel at a slant before it comes to its height.
TEST(Outcome, TellsAProjectileThatFlewPastTheTarget) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto run =
        compute({held, "projectile.position=[11 mm, 0, -9 mm]", "projectile.velocity=[400 m/s, 0, 200 m/s]"},
                1.5e-4, comm);
    EXPECT_EQ(run.outcome.verdict, Verdict::passed);
    ASSERT_TRUE(run.passages[0]);
    EXPECT_EQ(run.passages[0]->way, Way::beside);
}

TEST(Outcome, IsOpenWhileTheProjectileMovesOn) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto run = compute({held}, 5e-6, comm);
    EXPECT_EQ(run.outcome.verdict, Verdict::still_moving);
    EXPECT_FALSE(run.outcome.decided_at);
}

TEST(Penetration, IsThatOfTheDeepestPointWithItsPlace) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"projectile={shape: cylinder, diameter: 3 mm, length: 10 mm, mass: 0.5 "
                                      "g, position: [1 mm, -1 mm, -5 mm], "
                                      "velocity: [0, 0, 200 m/s]}",
                                      "fabrics.kevlar129.contact_thickness=0.2 mm"}),
                          comm);
    simulation.advance_forces();
    EXPECT_EQ(simulation.record_balance().deepest.element, -1);
    simulation.integrate();
    auto& projectile = simulation.model().projectiles.front().body;
    projectile.place({1e-3, -1e-3, 0.03e-3}, projectile.attitude(), projectile.velocity());
    simulation.advance_forces();
    const auto deepest = simulation.record_balance().deepest;
    EXPECT_NEAR(deepest.overlap, 0.13e-3, 1e-9);  // half of the thickness more
    EXPECT_NEAR(deepest.in_thicknesses, 0.65, 1e-5);
    EXPECT_LT((deepest.place.head<2>() - Vec3(1e-3, -1e-3, 0).head<2>()).norm(), 1.5e-3);
    EXPECT_EQ(simulation.deepest().element, deepest.element);
    simulation.integrate();
    projectile.place({1e-3, -1e-3, -5e-3}, projectile.attitude(), projectile.velocity());
    simulation.advance_forces();
    EXPECT_EQ(simulation.record_balance().deepest.overlap, deepest.overlap)
        << "it stays when the projectile has gone";
}

}  // namespace weavefront::solver::test
