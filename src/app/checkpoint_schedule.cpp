#include "checkpoint_schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace weavefront::app {

namespace {

// Of a disk that is slow and shared: the first checkpoint has nothing to be estimated from.
constexpr double slow_disk = 5e7;  // bytes/s

// The file `stop` is looked for so often.
constexpr auto between_looks = std::chrono::seconds(1);

/// End of the Slurm job, as Slurm tells its processes.
std::optional<std::chrono::system_clock::time_point> end_of_job() {
    const char* text = std::getenv("SLURM_JOB_END_TIME");
    if (!text) return std::nullopt;
    const long long seconds = std::atoll(text);
    if (seconds <= 0) return std::nullopt;
    return std::chrono::system_clock::time_point(std::chrono::seconds(seconds));
}

double seconds_of(auto duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

CheckpointSchedule::CheckpointSchedule(const CheckpointPlan& plan, const std::filesystem::path& folder,
                                       double bytes)
    : plan_(plan), stop_file_(folder / "stop"), job_end_(end_of_job()), longest_(1 + bytes / slow_disk) {}

bool CheckpointSchedule::is_due() const {
    return plan_.interval && seconds_of(Clock::now() - last_) >= *plan_.interval;
}

// Twice the time of the longest one, for a disk that is busier then, and some seconds for rows, frame and
// summary.
double CheckpointSchedule::margin() const { return 2 * longest_ + 5; }

std::string CheckpointSchedule::reason_to_stop() {
    if (plan_.walltime && seconds_of(Clock::now() - plan_.begin) > *plan_.walltime - margin())
        return fmt::format("the wall time of {:.6g} s is nearly over", *plan_.walltime);
    if (job_end_ && seconds_of(*job_end_ - std::chrono::system_clock::now()) < margin())
        return "the Slurm job is about to end";
    if (Clock::now() - looked_ < between_looks) return {};
    looked_ = Clock::now();
    std::error_code unknown;
    if (!std::filesystem::exists(stop_file_, unknown)) return {};
    std::filesystem::remove(stop_file_, unknown);  // so that a restarted run does not find it
    return "the file " + stop_file_.string() + " was found";
}

void CheckpointSchedule::written(double seconds) {
    longest_ = std::max(longest_, seconds);
    last_ = Clock::now();
}

}  // namespace weavefront::app
