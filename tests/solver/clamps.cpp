/// Fabric that is held beyond the opening of the frame.

#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

constexpr double pressure = 2e6, mu = 0.2;
const std::vector<std::string> round_clamp{
    "target.edges={x: {clamp: {pressure: 2 MPa, friction: 0.2}}, y: {clamp: {pressure: 2 MPa, friction: "
    "0.2}}}",
    "target.frame={opening: {diameter: 16 mm}, edge_radius: 0.5 mm}", "target.mesh.center=1 mm"};

// A ply that lies in the clamp but for its middle slides like a block: v^2/2 = a s with a = 2 mu p/m.
TEST(Clamp, LetsAPlySlideAsFarAsFrictionTakesItsEnergy) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    auto overrides = round_clamp;
    overrides.emplace_back("target.frame.opening.diameter=0.1 mm");
    Simulation simulation(scene_with(overrides), comm);
    constexpr double speed = 20, mass = 0.204;
    set_motion(
        simulation, [](const Vec3& x) { return x; },
        [](const Vec3&) { return Vec3(0.6 * speed, 0.8 * speed, 0); });
    simulation.model().projectiles.front().body.place({0, 0, -1}, {}, {0, 0, 0});  // far away
    const double deceleration = 2 * mu * pressure / mass, stop = speed / deceleration;
    while (simulation.time() < 2 * stop) advance(simulation, 1);
    simulation.advance_forces();
    const double way = speed * speed / (2 * deceleration);
    // Until it slips, the ply moves by mu p/k_t, and at the end it swings about its place by as much: 0.1 um.
    const double elastic = mu * pressure / (0.8 * 5.6e12);
    const double before = speed * simulation.time_step() / 2;  // there is no friction at the start
    const auto& nodes = simulation.model().nodes;
    for (std::size_t n = 0; n < static_cast<std::size_t>(nodes.count); ++n) {
        if (std::hypot(nodes.initial[n].x(), nodes.initial[n].y()) < 6e-3) continue;  // the middle slides on
        const Vec3 moved = nodes.x[n] - nodes.initial[n];
        EXPECT_NEAR(moved.norm(), way + before, 2 * elastic + 0.01 * way);
        EXPECT_NEAR(moved.y() / moved.x(), 0.8 / 0.6, 0.02);
    }
}

TEST(Clamp, HoldsTheFabricInItsPlaneAndClosesTheLedger) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with(round_clamp), comm);
    double error = 0, lowest = 0, slid = 0;
    for (int n = 0; n < 1000; ++n) {
        simulation.advance_forces();
        const auto balance = simulation.balance();
        error = std::max(error, std::abs(balance.energy_error));
        ASSERT_TRUE(balance.contact_friction.has_value());
        lowest = std::min(lowest, *balance.contact_friction);
        const auto& nodes = simulation.model().nodes;
        for (std::size_t i = 0; i < static_cast<std::size_t>(nodes.count); ++i) {
            const Vec3 at = nodes.initial[i];
            if (std::hypot(at.x(), at.y()) <= 8e-3) continue;
            ASSERT_EQ(nodes.x[i].z(), at.z());
            slid = std::max(slid, (nodes.x[i] - at).norm());
        }
        simulation.integrate();
    }
    EXPECT_GT(comm.max(slid), 0.1e-3) << "m";
    EXPECT_LT(error, 1e-3);
    EXPECT_GE(lowest, -1e-9) << "J";
    EXPECT_GT(*(simulation.advance_forces(), simulation.balance()).contact_friction, 0.05) << "J";
}

TEST(Clamp, IsTheTighterTheHarderItPresses) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto slid = [&](const std::string& edge) {
        auto overrides = round_clamp;
        overrides.push_back("target.edges={x: " + edge + ", y: " + edge + "}");
        overrides.emplace_back("projectile.velocity=[0, 0, 60 m/s]");
        Simulation simulation(scene_with(overrides), comm);
        advance(simulation, 1000);
        const auto& nodes = simulation.model().nodes;
        double farthest = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(nodes.count); ++i)
            if (std::hypot(nodes.initial[i].x(), nodes.initial[i].y()) > 8e-3)
                farthest = std::max(farthest, (nodes.x[i] - nodes.initial[i]).norm());
        return comm.max(farthest);
    };
    const auto clamp = [](const std::string& by) { return "{clamp: {pressure: " + by + ", friction: 0.2}}"; };
    const double loose = slid(clamp("10 MPa")), firm = slid(clamp("100 MPa")), tight = slid(clamp("1 GPa"));
    EXPECT_GT(loose, 2 * firm);
    EXPECT_GT(firm, 2 * tight);
    EXPECT_EQ(slid("fixed"), 0);
}

}  // namespace
}  // namespace weavefront::solver::test
