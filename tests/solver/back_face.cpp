#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {

// The first ply lies farther back than the last; a corner of the last is farther back still, until its only element is eroded.
TEST(BackFace, IsTheLastPlyWhereItIsNotEroded) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"target.plies.count=2"}), comm);
    simulation.advance_forces();
    auto& model = simulation.model();
    const double last = model.nodes.initial.heights.back(), corner = 11.9e-3;
    const auto at_corner = [&](const Vec3& x) { return x.x() > corner && x.y() > corner; };
    set_motion(
        simulation,
        [&](const Vec3& x) {
            return Vec3(x + Vec3(0, 0, x.z() != last ? 3e-3 : at_corner(x) ? 2e-3 : 1e-3));
        },
        [](const Vec3&) { return Vec3(0, 0, 0); });
    EXPECT_NEAR(simulation.balance().back_face_deflection, 2e-3, 1e-9);
    for (std::size_t f = 0; f < static_cast<std::size_t>(model.surface.owned); ++f)
        for (const auto node : model.surface.facets[f].nodes)
            if (at_corner(model.nodes.x[static_cast<std::size_t>(node)])) model.surface.alive[f] = 0;
    const auto balance = simulation.balance();
    EXPECT_NEAR(balance.back_face_deflection, 1e-3, 1e-9);
    EXPECT_NEAR(balance.max_displacement, 3e-3, 1e-9);
}

}  // namespace weavefront::solver::test
