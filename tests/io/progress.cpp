#include "weavefront/io/progress.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "scratch_directory.hpp"
#include "weavefront/io/file_error.hpp"

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
        log.publish();
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
    EXPECT_NE(printed.find("  50 %  50.00 of 100.00 us  step 500  projectile 212.4 m/s  30 s left\n"),
              std::string::npos)
        << printed;
    EXPECT_NE(printed.find(" 100 %  100.00 of 100.00 us  step 1000  projectile 212.4 m/s\ndone\n"),
              std::string::npos)
        << printed;
    EXPECT_EQ(content(directory / "run.log"), printed);
}

TEST(Log, FailsOnAllRanksWithoutItsDirectory) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    const auto message = message_of<FileError>([&] { Log(directory / "missing", comm); });
    EXPECT_EQ(message,
              (directory / "missing/run.log").string() + " cannot be written: No such file or directory");
}

// The file system takes no more than the first line, as a full one may.
TEST(Log, CountsTheLinesThatItsFileLacks) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    testing::internal::CaptureStderr();
    const std::string first(10000, 'x');
    {
        Log log(directory / "", comm, Terminal::silent);
        log.publish();
        log.info(first);
        const rlimit limit{first.size() + 5, before.rlim_max};  // room for what is told meanwhile
        ::setrlimit(RLIMIT_FSIZE, &limit);
        log.info("second line");
        log.info("third line");
        ::setrlimit(RLIMIT_FSIZE, &before);
    }
    std::signal(SIGXFSZ, handler);
    const auto told = testing::internal::GetCapturedStderr();
    if (comm.rank() != 0) return;
    EXPECT_EQ(content(directory / "run.log"), first + "\n");
    EXPECT_NE(told.find("warning: a line of the log is lost: " + (directory / "run.log").string() +
                        " cannot be written: File too large\n"),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("warning: run.log lacks 2 lines\n"), std::string::npos) << told;
}

}  // namespace
}  // namespace weavefront::io
