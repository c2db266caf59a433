#include "weavefront/io/progress.hpp"

#include <gtest/gtest.h>

#include "scratch_directory.hpp"

namespace weavefront::io {
namespace {

TEST(RemainingTime, FollowsTheRateOfTheLastWindow) {
    RemainingTime remaining(100, 10);
    EXPECT_FALSE(remaining.left());
    for (int wall = 0; wall <= 20; ++wall) remaining.add(wall, wall);
    EXPECT_DOUBLE_EQ(*remaining.left(), 80);
    // Twice as slow from here on; after a full window nothing is left of the old rate.
    for (int wall = 21; wall <= 40; ++wall) remaining.add(20 + 0.5 * (wall - 20), wall);
    EXPECT_DOUBLE_EQ(*remaining.left(), 140);
}

TEST(DurationText, NamesTwoUnitsAtMost) {
    EXPECT_EQ(duration_text(7.6), "8 s");
    EXPECT_EQ(duration_text(59.7), "1 min 00 s");
    EXPECT_EQ(duration_text(200), "3 min 20 s");
    EXPECT_EQ(duration_text(7500), "2 h 05 min");
}

TEST(Progress, WritesALineAtEveryTenthOffTheTerminal) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    testing::internal::CaptureStdout();
    {
        Log log(directory / "", comm);
        double wall = 0;
        Progress progress(log, 100e-6, [&] { return wall; });
        for (int step = 0; step <= 1000; ++step) {
            wall = 0.06 * step;
            progress.update(step * 1e-7, step, "projectile 212.4 m/s");
        }
        progress.finish();
        log.info("done");
    }
    const std::string printed = testing::internal::GetCapturedStdout();
    if (comm.rank() != 0) {
        EXPECT_EQ(printed, "");
        return;
    }
    EXPECT_EQ(std::count(printed.begin(), printed.end(), '\n'), 11);
    EXPECT_NE(printed.find("  50 %  50.00 of 100.00 us  step 500  projectile 212.4 m/s  30 s left\n"), std::string::npos) << printed;
    EXPECT_NE(printed.find(" 100 %  100.00 of 100.00 us  step 1000  projectile 212.4 m/s\ndone\n"), std::string::npos) << printed;
    EXPECT_EQ(content(directory / "run.log"), printed);
}

TEST(Log, FailsOnAllRanksWithoutItsDirectory) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    // spdlog creates missing folders, so a file stands in the way.
    if (comm.rank() == 0) std::ofstream(directory / "file") << "text";
    EXPECT_THROW(Log(directory / "file", comm), std::runtime_error);
}

}  // namespace
}  // namespace weavefront::io
