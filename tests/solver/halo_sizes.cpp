/// What partition::halo_sizes counts is what the solver links.

#include "weavefront/partition/halo_sizes.hpp"

#include <gtest/gtest.h>

#include "small_scene.hpp"
#include "weavefront/partition/run_decomposition.hpp"

namespace weavefront::solver::test {
namespace {

TEST(HaloSizes, AreThoseOfTheLinks) {
    for (const char* plies : {"1", "3"}) {
        const auto scene =
            scene_with({std::string("target.plies.count=") + plies, "target.mesh.center=1 mm"});
        const parallel::Communicator comm(MPI_COMM_WORLD);
        const Simulation simulation(scene, comm);
        const auto& panel = simulation.panel();
        const auto decomposition =
            partition::decompose_for_run(scene, panel, comm.size(), ghost_reach(scene, panel));
        const auto sizes = partition::halo_sizes(panel, decomposition, ghost_reach(scene, panel));
        const auto& mine = sizes[static_cast<std::size_t>(comm.rank())];

        const auto& model = simulation.model();
        std::int64_t sent = 0, received = 0;
        for (const auto& neighbour : model.exchange.neighbours()) {
            sent += partition::force_bytes * static_cast<std::int64_t>(neighbour.out.dense_count);
            received += partition::force_bytes * static_cast<std::int64_t>(neighbour.in.dense_count);
        }
        EXPECT_EQ(mine.bytes_sent, sent);
        EXPECT_EQ(mine.bytes_received, received);
        EXPECT_EQ(mine.messages, static_cast<std::int64_t>(model.exchange.neighbours().size()));
        EXPECT_EQ(mine.nodes, model.nodes.count);
        EXPECT_EQ(mine.ghosts, static_cast<std::int64_t>(model.nodes.x.size()) - model.nodes.count);
        EXPECT_EQ(mine.columns * static_cast<std::int64_t>(panel.plies.size()),
                  static_cast<std::int64_t>(model.slots.size()));
    }
}

}  // namespace
}  // namespace weavefront::solver::test
