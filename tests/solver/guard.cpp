#include "weavefront/solver/guard.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "small_scene.hpp"

namespace weavefront::solver::test {

// One node of the last rank goes astray: all ranks must leave, with one message that names an element there.
TEST(Guard, StopsAllRanksAtAForceThatIsNotFinite) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"projectile=", "contact=", "target.plies.count=2"}), comm);
    advance(simulation, 3);
    auto& nodes = simulation.model().nodes;
    if (comm.rank() == comm.size() - 1)
        nodes.v[static_cast<std::size_t>(nodes.count) - 1].y() = std::numeric_limits<double>::quiet_NaN();
    std::string message;
    try {
        advance(simulation, 2);
    } catch (const GuardStop& stop) {
        message = stop.what();
    }
    EXPECT_NE(message.find("(ply 2, at x = "), message.npos) << message;
    EXPECT_NE(message.find("step 4"), message.npos) << message;
    EXPECT_EQ(message, comm.broadcast(message)) << "not the message of rank 0";
}

}  // namespace weavefront::solver::test
