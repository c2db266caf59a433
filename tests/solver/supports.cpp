#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {

TEST(Supports, FixedEdgesStayAndSlidingEdgesMoveInThePlaneOnly) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(
        scene_with({"target.edges={x: fixed, y: sliding}", "projectile.velocity=[30 m/s, 20 m/s, 200 m/s]"}),
        comm);
    advance(simulation, 200);
    const auto& nodes = simulation.model().nodes;
    double slid = 0, lifted = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(nodes.count); ++n) {
        const Vec3 moved = nodes.x[n] - nodes.initial[n];
        const bool on_x = std::abs(nodes.initial[n].x()) > 11.9e-3,
                   on_y = std::abs(nodes.initial[n].y()) > 11.9e-3;
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

// An impact that pulls the fabric over the frame: 2 mm of it lie on the bars at the start.
TEST(Supports, FabricSlidesOnTheFrameLiftsOffItAndNeverPasses) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(
        scene_with({"target.edges={x: fixed, y: frame}",
                    "target.frame={opening: {y: 20 mm}, edge_radius: 0.5 mm}", "target.mesh.center=1 mm"}),
        comm);
    const double quarter =
        0.25 * simulation.panel().plies[0].z + 0.1417e-3 / 4;  // of a thickness, below what contact lets in
    double deepest = 0, slid = 0, error = 0, lifted = 0;
    for (int n = 0; n < 1000; ++n) {
        simulation.advance_forces();
        error = std::max(error, std::abs(simulation.balance().energy_error));
        const auto& nodes = simulation.model().nodes;
        for (std::size_t i = 0; i < static_cast<std::size_t>(nodes.count); ++i) {
            const bool on_bar = std::abs(nodes.x[i].y()) > 10.5e-3;  // beyond the rounded edge
            if (on_bar && std::abs(nodes.initial[i].x()) < 11.9e-3) {
                deepest = std::max(deepest, nodes.x[i].z());
                lifted = std::max(lifted, -nodes.x[i].z());
            }
            if (std::abs(nodes.initial[i].y()) > 11.9e-3)
                slid = std::max(slid, std::abs(nodes.initial[i].y()) - std::abs(nodes.x[i].y()));
        }
        simulation.integrate();
    }
    EXPECT_LT(comm.max(deepest), quarter) << "m";
    EXPECT_GT(comm.max(slid), 0.5e-3) << "m";
    EXPECT_GT(comm.max(lifted), 1e-5) << "m, the wave along the fabric throws it up";
    EXPECT_LT(error, 1e-4) << "work against the frame is in the ledger";
    EXPECT_GE(simulation.counts().lowest_contact_energy, 0);
}

// Momentum of a free target and its projectile stays; a frame takes some of it and gives none, until the
// fabric has slipped off it.
TEST(Supports, AFrameTakesMomentum) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation framed(
        scene_with({"target.edges={x: frame, y: frame}", "target.frame={opening: {x: 16 mm, y: 16 mm}}"}),
        comm);
    const double initial = 0.5e-3 * 200;
    double last = initial;
    for (int n = 0; n < 600; ++n) {
        framed.advance_forces();
        framed.integrate();
        const auto& nodes = framed.model().nodes;
        const double fabric =
            sum_over_nodes(framed, comm, 0.0, [&](std::size_t i) { return nodes.mass[i] * nodes.v[i].z(); });
        const double now = fabric + 0.5e-3 * framed.model().projectiles.front().body.velocity().z();
        ASSERT_LT(now, last + 1e-12 * initial) << "the frame pulled, step " << n;
        last = now;
    }
    EXPECT_LT(last, 0.98 * initial) << "the corners that stay on the bars are pressed on them";
}

}  // namespace weavefront::solver::test
