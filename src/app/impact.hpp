#pragma once
/// @file
/// One impact, from its scene to its folder of results.

#include <memory>
#include <optional>

#include "checkpoint_schedule.hpp"
#include "restart.hpp"
#include "run_report.hpp"
#include "weavefront/io/log.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// How an impact is computed, apart from its scene.
struct ImpactOptions {
    io::Terminal terminal = io::Terminal::shown;  ///< whether the log is shown
    std::optional<double> rebalance{};  ///< imbalance of the ranks above which columns move; none: they stay
    CheckpointPlan checkpoints{};
    const Restart* restart = nullptr;  ///< null: from the start; must outlive the impact
};

/// One impact: what it computes with and what it writes.
class Impact {
  public:
    /// @param scene     must outlive this object
    /// @param directory for history.csv, results.vtkhdf, summary.json and run.log; what it holds of an
    /// earlier run stays until `run`; must outlive this object
    /// @param comm      ranks that compute it; must outlive this object
    /// @note Collective
    Impact(const scene::Scene& scene, io::OutputDirectory& directory, const parallel::Communicator& comm,
           const ImpactOptions& options = {});
    ~Impact();
    Impact(const Impact&) = delete;
    Impact& operator=(const Impact&) = delete;

    /// Computes to the end, or until a rank is sent a signal to stop, and writes everything. @throws
    /// Interrupted when that was sent before
    [[nodiscard]] Ending run();

  private:
    class Run;
    std::unique_ptr<Run> run_;
};

/// Refuses more ranks than columns of elements. @throws scene::InputError
void require_columns(const scene::Scene& scene, int ranks);

/// The number of columns of elements: the most ranks that an impact can use.
int columns_of(const scene::Scene& scene);

}  // namespace weavefront::app
