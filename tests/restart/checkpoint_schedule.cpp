/// When a run writes a checkpoint and when it leaves by itself.

#include "checkpoint_schedule.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace weavefront::app {
namespace {

using std::chrono::seconds;

/// A folder of its own, and no Slurm job around.
class Schedule : public ::testing::Test {
  protected:
    void SetUp() override { ::unsetenv("SLURM_JOB_END_TIME"); }
    void TearDown() override {
        ::unsetenv("SLURM_JOB_END_TIME");
        std::filesystem::remove_all(folder_);
    }
    static std::string folder() {
        std::string path = (std::filesystem::temp_directory_path() / "weavefront.XXXXXX").string();
        return ::mkdtemp(path.data()) == nullptr ? "" : path;
    }
    const std::filesystem::path folder_ = folder();
};

TEST_F(Schedule, CountsTheWallTimeFromTheStartOfTheProgram) {
    CheckpointPlan plan;
    plan.walltime = 3600;
    EXPECT_EQ(CheckpointSchedule(plan, folder_, 0).reason_to_stop(), "");
    plan.begin -= seconds(3595);  // a set-up that took nearly all of it
    EXPECT_EQ(CheckpointSchedule(plan, folder_, 0).reason_to_stop(),
              "the wall time of 3600 s is nearly over");
}

TEST_F(Schedule, KeepsTwiceTheTimeOfTheLongestCheckpoint) {
    CheckpointPlan plan;
    plan.walltime = 3600;
    plan.begin -= seconds(3500);
    CheckpointSchedule schedule(plan, folder_, 0);
    EXPECT_EQ(schedule.reason_to_stop(), "");
    schedule.written(60);
    EXPECT_NE(schedule.reason_to_stop(), "");
    // 10 GB at 50 MB/s: before any was written.
    EXPECT_NE(CheckpointSchedule(plan, folder_, 1e10).reason_to_stop(), "");
}

TEST_F(Schedule, LeavesBeforeTheEndOfTheSlurmJob) {
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    ::setenv("SLURM_JOB_END_TIME", std::to_string(now + 3600).c_str(), 1);
    EXPECT_EQ(CheckpointSchedule({}, folder_, 0).reason_to_stop(), "");
    ::setenv("SLURM_JOB_END_TIME", std::to_string(now + 5).c_str(), 1);
    EXPECT_EQ(CheckpointSchedule({}, folder_, 0).reason_to_stop(), "the Slurm job is about to end");
    for (const char* unknown : {"", "Unknown", "0", "-1"}) {
        ::setenv("SLURM_JOB_END_TIME", unknown, 1);
        EXPECT_EQ(CheckpointSchedule({}, folder_, 0).reason_to_stop(), "") << unknown;
    }
}

TEST_F(Schedule, IsDueAfterSoManyStepsOrSoMuchTime) {
    CheckpointPlan plan;
    plan.steps = 50;
    EXPECT_FALSE(CheckpointSchedule(plan, folder_, 0).is_due());
    EXPECT_FALSE(CheckpointSchedule(plan, folder_, 0).is_due_at(49));
    EXPECT_TRUE(CheckpointSchedule(plan, folder_, 0).is_due_at(100));
    plan = {};
    EXPECT_FALSE(CheckpointSchedule(plan, folder_, 0).is_due_at(100));
    plan.interval = 0;
    CheckpointSchedule schedule(plan, folder_, 0);
    EXPECT_TRUE(schedule.is_due());
}

}  // namespace
}  // namespace weavefront::app
