#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {

TEST(Supports, FixedEdgesStayAndSlidingEdgesMoveInThePlaneOnly) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"target.edges={x: fixed, y: sliding}", "projectile.velocity=[30 m/s, 20 m/s, 200 m/s]"}), comm);
    advance(simulation, 200);
    const auto& nodes = simulation.model().nodes;
    double slid = 0, lifted = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(nodes.count); ++n) {
        const Vec3 moved = nodes.x[n] - nodes.initial[n];
        const bool on_x = std::abs(nodes.initial[n].x()) > 11.9e-3, on_y = std::abs(nodes.initial[n].y()) > 11.9e-3;
        if (on_x) {
            EXPECT_EQ(moved, Vec3::Zero()) << "a fixed node moved";
            EXPECT_EQ(nodes.v[n], Vec3::Zero());
        }
        if (on_y) {
            EXPECT_EQ(moved.z(), 0) << "a sliding node left the plane";
        }
        if (on_y && !on_x) slid = std::max(slid, std::abs(moved.y()));
        if (!on_x && !on_y) lifted = std::max(lifted, std::abs(moved.z()));
    }
    EXPECT_GT(comm.max(slid), 1e-5) << "m";
    EXPECT_GT(comm.max(lifted), 1e-3) << "m";
}

}  // namespace weavefront::solver::test
