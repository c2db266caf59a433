#include <gtest/gtest.h>

#include "small_scene.hpp"
#include "weavefront/solver/redistribution.hpp"

namespace weavefront::solver::test {

namespace {

/// A ply slides over another by three facets before they touch; a corner flies off on its own.
scene::Scene two_plies() { return scene_with({"target.plies.count=2", "projectile=", "contact={plies: {}, spacing: 0.5 mm}"}); }

void slide(Simulation& simulation) {
    const double last = simulation.model().nodes.initial.heights.back();
    set_motion(
        simulation, [](const Vec3& x) { return x; },
        [&](const Vec3& x) {
            if (x.x() > 11.9e-3 && x.y() > 11.9e-3) return Vec3(900, -700, 0);
            return x.z() == last ? Vec3(400, 150, -7) : Vec3(0, 0, 0);
        });
}

}  // namespace

// Forces are those of a target for which what may meet is looked for every other step.
TEST(Search, ComesInTime) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = two_plies();
    Simulation sparing(scene, comm), eager(scene, comm);
    slide(sparing), slide(eager);
    partition::Decomposition columns{comm.size(), {}};
    for (std::int64_t c = 0; c < eager.panel().columns(); ++c) columns.owner.push_back(static_cast<std::int32_t>(c % comm.size()));
    double most = 0;
    for (int steps = 0; sparing.time() < 25e-6; ++steps) {
        sparing.advance_forces();
        eager.advance_forces();
        if (steps % 20 == 0) {
            const auto a = sparing.balance(), b = eager.balance();
            ASSERT_EQ(a.contact, b.contact) << steps;
            ASSERT_EQ(a.kinetic_fabric, b.kinetic_fabric) << steps;
            most = std::max(most, a.contact);
        }
        sparing.integrate();
        eager.integrate();
        if (steps % 2 == 0) eager.redistribute(columns);
    }
    EXPECT_GT(most, 0);
}

TEST(Search, IsToldOf) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = two_plies(), without_contact = scene_with({"projectile=", "contact="});
    Simulation sliding(scene, comm), alone(without_contact, comm);
    slide(sliding);
    std::int64_t told = 0;
    const auto before = sliding.counts().searches;
    while (sliding.time() < 10e-6) {
        advance(sliding, 1);
        advance(alone, 1);
        told += sliding.has_just_searched() ? 1 : 0;
        EXPECT_TRUE(alone.has_just_searched());
    }
    EXPECT_GT(told, 0);
    EXPECT_EQ(told, sliding.counts().searches - before);
}

}  // namespace weavefront::solver::test
