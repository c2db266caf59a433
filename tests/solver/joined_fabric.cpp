#include "weavefront/solver/joined_fabric.hpp"

#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

const std::string breaks = "fabrics.kevlar129.failure={static_strain: 3 %, hooke_strain: 3 %}";
constexpr double edge = 2e-3;

/// Moves every node at once, which breaks the yarns that are stretched by it.
template <class Displacement>
void displace(Simulation& simulation, Displacement displacement) {
    simulation.advance_forces();
    set_motion(
        simulation, [&](const Vec3& x) { return Vec3(x + displacement(x)); },
        [](const Vec3&) { return Vec3(0, 0, 0); });
    simulation.integrate();
    simulation.advance_forces();
}

}  // namespace

// A corner node flies off: its only element loses both yarns, and nothing holds the node any more.
TEST(JoinedFabric, LosesTheNodesOfErodedElements) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"projectile=", "contact=", "target.plies.count=2", breaks}), comm);
    const double last = simulation.model().nodes.initial.heights.back();
    displace(simulation, [&](const Vec3& x) {
        const bool at_corner = x.z() == last && x.x() > 11.9e-3 && x.y() > 11.9e-3;
        return at_corner ? Vec3(edge / 2, edge / 2, 5e-3) : Vec3(0, 0, x.z() == last ? 1e-3 : 3e-3);
    });
    const auto balance = simulation.balance();
    EXPECT_EQ(balance.eroded_elements, 1);
    EXPECT_EQ(balance.debris_elements, 0);
    EXPECT_NEAR(balance.debris_displacement, 5e-3, 1e-9);
    EXPECT_NEAR(balance.debris_mass, 0.204 * edge * edge / 4, 1e-15);
    EXPECT_NEAR(balance.back_face_deflection, 1e-3, 1e-9) << "of the last ply, without what has torn off";
    EXPECT_NEAR(balance.max_displacement, 3e-3, 1e-9);
}

// Two columns of elements away from an edge the fill yarns break over the whole width. What they held is
// debris, though the warp yarns of the torn column run on along it.
TEST(JoinedFabric, OfAPlyThatNothingHoldsIsItsLargestPiece) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"projectile=", "contact=", breaks}), comm);
    displace(simulation,
             [&](const Vec3& x) { return Vec3(x.x() > 7e-3 ? 0.3e-3 : 0, 0, x.x() > 7e-3 ? 1e-3 : 0); });
    const auto balance = simulation.balance();
    EXPECT_EQ(balance.broken_yarns, 12);
    EXPECT_EQ(balance.eroded_elements, 0);
    EXPECT_EQ(balance.debris_elements, 2 * 12);
    EXPECT_NEAR(balance.debris_displacement, 1e-3, 1e-9);
    EXPECT_NEAR(balance.max_displacement, 0, 1e-9);
}

// Held along x = +-12 mm, both pieces are joined.
TEST(JoinedFabric, IsWhatYarnsJoinToASupport) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto debris = [&](const std::vector<std::string>& edges) {
        std::vector<std::string> overrides{"projectile=", "contact=", breaks};
        overrides.insert(overrides.end(), edges.begin(), edges.end());
        Simulation simulation(scene_with(overrides), comm);
        displace(simulation, [&](const Vec3& x) { return Vec3(x.x() > 7e-3 ? 0.3e-3 : 0, 0, 0); });
        return simulation.balance().debris_elements;
    };
    EXPECT_EQ(debris({"target.edges.x=fixed"}), 0);
    EXPECT_EQ(debris({"target.edges.y=sliding"}), 0);
    EXPECT_EQ(debris({"target.symmetry=[x]", "target.edges.x=fixed"}), 2 * 3 * 12)
        << "a plane of symmetry is no support";
}

TEST(JoinedFabric, OfAPlyTurnedBy45DegreesIsJoinedAslant) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"projectile=", "contact=",
                                      "target.plies={count: 1, fabric: kevlar129, angle: 45 deg}", breaks}),
                          comm);
    displace(simulation, [&](const Vec3& x) { return Vec3(x.x() > 7e-3 ? 0.3e-3 : 0, 0, 0); });
    const auto balance = simulation.balance();
    EXPECT_GT(balance.broken_yarns, 0);
    EXPECT_EQ(balance.eroded_elements, 12);
    EXPECT_EQ(balance.debris_elements, 2 * 12);
}

}  // namespace weavefront::solver::test
