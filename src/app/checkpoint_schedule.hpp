#pragma once
/// @file
/// When a run writes a checkpoint, and when it has to leave by itself.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace weavefront::app {

/// What the user asks for.
struct CheckpointPlan {
    std::optional<double> interval;     ///< wall time between checkpoints, s
    std::optional<std::int64_t> steps;  ///< steps between them
    std::optional<double> walltime;     ///< wall time that the program may take, s
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();  ///< of the program
};

/// Looks at the clock, at the job's end and for the file `stop`. One process does it and tells the others.
class CheckpointSchedule {
  public:
    /// @param folder of the run
    /// @param bytes  of a checkpoint, from which the time of the first one is estimated
    CheckpointSchedule(const CheckpointPlan& plan, const std::filesystem::path& folder, double bytes);

    /// Whether the interval of wall time is over. Cheap enough for every step.
    [[nodiscard]] bool is_due() const;
    /// Whether a checkpoint is due at a step, which all ranks know.
    [[nodiscard]] bool is_due_at(std::int64_t step) const { return plan_.steps && step % *plan_.steps == 0; }
    /// Why the run has to leave now; empty: it does not. Cheap enough for every step.
    [[nodiscard]] std::string reason_to_stop();

    /// A checkpoint was written. @param seconds that it took
    void written(double seconds);

  private:
    using Clock = std::chrono::steady_clock;
    /// Before the end of the time so much is kept for the last checkpoint and the files, s.
    [[nodiscard]] double margin() const;

    CheckpointPlan plan_;
    std::filesystem::path stop_file_;
    Clock::time_point last_ = Clock::now(), looked_ = last_;
    std::optional<std::chrono::system_clock::time_point> job_end_;
    double longest_;  ///< time of a checkpoint, s
};

}  // namespace weavefront::app
