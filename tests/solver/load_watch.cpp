/// When a run is rebalanced, and to what.

#include "weavefront/solver/load_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

constexpr double limit = 0.1;

/// A simulation at the end of a window, with all columns but a few on rank 0.
struct WatchedRun {
    WatchedRun() : scene(scene_with({})), simulation(scene, comm), watch(scene, limit) {
        partition::Decomposition uneven{comm.size(), {}};
        const auto columns = simulation.panel().columns();
        for (std::int64_t c = 0; c < columns; ++c)
            uneven.owner.push_back(
                static_cast<std::int32_t>(std::max<std::int64_t>(c - columns + comm.size(), 0)));
        simulation.redistribute(uneven);
    }
    /// Looks at a window in which rank 0 took `slowness` seconds and every other rank one.
    std::optional<Rebalancing> look_after(double slowness) {
        seconds += comm.rank() == 0 ? slowness : 1;
        simulation.seconds() = {};
        simulation.seconds()[static_cast<std::size_t>(Phase::elements)] = seconds;
        return watch.look(simulation, comm);
    }
    [[nodiscard]] double imbalance_of(double slowness) const {
        return slowness * comm.size() / (slowness + comm.size() - 1);
    }

    parallel::Communicator comm{MPI_COMM_WORLD};
    scene::Scene scene;
    Simulation simulation;
    LoadWatch watch;
    double seconds = 0;
};

TEST(LoadWatch, LeavesEvenRanksAlone) {
    WatchedRun run;
    for (int window = 0; window < 4; ++window) EXPECT_FALSE(run.look_after(1)) << window;
    if (run.comm.size() > 1) {
        EXPECT_DOUBLE_EQ(run.watch.worst(), 1);
    }
}

TEST(LoadWatch, DoesNotMeasureWithinAWindow) {
    WatchedRun run;
    advance(run.simulation, 1);
    for (int look = 0; look < 4; ++look) EXPECT_FALSE(run.look_after(100)) << look;
    EXPECT_EQ(run.watch.worst(), 0);
}

TEST(LoadWatch, BearsASingleUnevenWindow) {
    WatchedRun run;
    for (int window = 0; window < 3; ++window) {
        EXPECT_FALSE(run.look_after(3)) << window;
        EXPECT_FALSE(run.look_after(1)) << window;
    }
    if (run.comm.size() > 1) {
        EXPECT_DOUBLE_EQ(run.watch.worst(), run.imbalance_of(3));
    }
}

TEST(LoadWatch, SharesColumnsOutAnewAfterTwoUnevenWindows) {
    WatchedRun run;
    EXPECT_FALSE(run.look_after(3));
    const auto rebalancing = run.look_after(4);
    if (run.comm.size() == 1) {
        EXPECT_FALSE(rebalancing) << "one rank has nobody to share with";
        return;
    }
    ASSERT_TRUE(rebalancing);
    EXPECT_DOUBLE_EQ(rebalancing->measured, run.imbalance_of(4));
    EXPECT_LT(rebalancing->predicted, 1.2) << "144 columns can be shared out among four ranks";
    const auto& owner = rebalancing->decomposition.owner;
    ASSERT_EQ(owner.size(), static_cast<std::size_t>(run.simulation.panel().columns()));
    for (int rank = 0; rank < run.comm.size(); ++rank)
        EXPECT_GT(std::ranges::count(owner, rank), 144 / (2 * run.comm.size())) << rank;
    // every rank has the same owners
    std::vector<std::int64_t> largest(owner.begin(), owner.end());
    run.comm.min(largest);
    EXPECT_TRUE(std::ranges::equal(largest, owner));
    EXPECT_FALSE(run.look_after(4)) << "two more windows decide on the next change";
}

TEST(LoadWatch, KeepsADecompositionThatNoOtherImproves) {
    WatchedRun run;
    if (run.comm.size() == 1) return;
    run.look_after(3);
    run.simulation.redistribute(run.look_after(3)->decomposition);
    EXPECT_FALSE(run.look_after(3));
    EXPECT_FALSE(run.look_after(3)) << "a slow processor is no reason to move columns";
}

}  // namespace
}  // namespace weavefront::solver::test
