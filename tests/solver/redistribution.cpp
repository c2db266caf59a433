/// Columns that change ranks while a projectile perforates them.

#include "weavefront/solver/redistribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

/// Two plies on a frame that are perforated: every kind of memory that an element can have.
const std::vector<std::string> perforated{"target.plies.count=2", "fabrics.kevlar129.failure={static_strain: 3.3 %, hooke_strain: 2.7 %}",
                                          "target.edges={y: frame}", "target.frame={opening: {y: 16 mm}}",
                                          "projectile.velocity=[0, 0, 600 m/s]"};

/// Owners that change from one round to the next without any order.
partition::Decomposition scattered(const mesh::Panel& panel, int ranks, std::int64_t round) {
    partition::Decomposition decomposition{ranks, {}};
    for (std::int64_t c = 0; c < panel.columns(); ++c)
        decomposition.owner.push_back(static_cast<std::int32_t>((c * 7 + c / panel.columns_x() * 3 + round) % ranks));
    return decomposition;
}

TEST(Redistribution, LeavesNoTrace) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with(perforated);
    Simulation still(scene, comm), moved(scene, comm);
    constexpr int steps = 600, between = 50;
    for (int n = 0; n < steps; ++n) {
        still.advance_forces();
        moved.advance_forces();
        if (n % between == 0) {
            const auto a = still.balance(), b = moved.balance();
            ASSERT_EQ(a.projectile_velocity, b.projectile_velocity) << n;
            ASSERT_EQ(a.contact, b.contact) << n;
            ASSERT_EQ(a.internal, b.internal) << n;
            ASSERT_EQ(a.kinetic_fabric, b.kinetic_fabric) << n;
            ASSERT_EQ(a.eroded, b.eroded) << n;
            ASSERT_EQ(a.broken_yarns, b.broken_yarns) << n;
        }
        still.integrate();
        moved.integrate();
        if (n % between == between / 2) moved.redistribute(scattered(moved.panel(), comm.size(), n / between));
        ASSERT_EQ(still.time(), moved.time());
    }
    still.advance_forces();
    EXPECT_GT(still.balance().eroded_elements, 0);  // the scene does what it is here for
    EXPECT_GT(still.balance().contact, 0);
}

}  // namespace
}  // namespace weavefront::solver::test
