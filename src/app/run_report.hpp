#pragma once
/// @file
/// What a run says of itself: at the start, in its history and at the end.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "weavefront/io/log.hpp"
#include "weavefront/io/rows.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/solver/load_watch.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::app {

/// A balance as a row of history.csv. @param columns of elements, which all plies have
io::HistoryRow row_of(const solver::Balance& balance, std::int64_t columns);
/// A row with the parts that all rows of the run have.
io::HistoryRow history_layout(const solver::Simulation& simulation);

/// How a run has ended and why.
struct Ending {
    enum class Kind { finished, stopped, interrupted };
    Kind kind = Kind::finished;
    std::string reason;
};

class RunReport {
  public:
    /// Begins run.log with when, where and how the run was started. @note Collective
    RunReport(const scene::Scene& scene, const parallel::Communicator& comm, io::Log& log);

    /// What is computed and what is left out. @note Collective
    void start(const solver::Simulation& simulation);

    /// What to say of the projectile while the run goes on.
    [[nodiscard]] static std::string projectile_text(const solver::Simulation& simulation);

    /// Columns have moved between ranks.
    void rebalanced(const solver::Simulation& simulation, const solver::Rebalancing& rebalancing);
    /// They might have, and have not. @param worst slowest rank over the mean, at most; 0: never measured
    void never_rebalanced(double worst);

    /// The run goes on from a checkpoint. @param passed_over newer ones, and why they are of no use
    void restarted(const solver::Simulation& simulation, const std::filesystem::path& checkpoint,
                   const std::vector<std::string>& passed_over);
    void checkpoint_written(const solver::Simulation& simulation, const std::filesystem::path& path,
                            double seconds);

    /// The closing lines and summary.json. @param history_hash on rank 0 @note Collective
    void finish(solver::Simulation& simulation, const solver::Balance& last, const Ending& ending,
                const std::filesystem::path& directory, const std::string& history_hash);

    /// The last line of run.log: when the run has ended. `finish` ends with it.
    void record_end();

  private:
    void tell_lack_of_shared_memory(const solver::Simulation& simulation);

    const scene::Scene& scene_;
    const parallel::Communicator& comm_;
    io::Log& log_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now(), computing_;
    bool is_lack_told_ = false;
};

}  // namespace weavefront::app
