#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {

// A corner of the panel crosses the opposite edge of its only element, comes back, and is still counted then,
// as at the end of a run.
TEST(FoldedElements, AreCountedWithEveryRow) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({}), comm);
    simulation.advance_forces();
    const auto counted = [&] {
        static_cast<void>(simulation.record_balance());
        return simulation.counts().inverted;
    };
    EXPECT_EQ(counted(), 0);
    const auto move_corner = [&](const Vec3& from, const Vec3& to) {
        set_motion(
            simulation, [&](const Vec3& x) { return (x - from).norm() < 1e-6 ? to : x; },
            [](const Vec3&) { return Vec3(0, 0, 0); });
    };
    const Vec3 corner(12e-3, 12e-3, 0), across(9e-3, 10.5e-3, 0);
    move_corner(corner, across);
    EXPECT_EQ(counted(), 1);
    move_corner(across, corner);
    EXPECT_EQ(counted(), 1);
}

}  // namespace weavefront::solver::test
