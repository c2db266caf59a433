#include "impact.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "commands.hpp"
#include "frames.hpp"
#include "projectile_surface.hpp"
#include "run_report.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/history.hpp"
#include "weavefront/io/progress.hpp"
#include "weavefront/io/results.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/guard.hpp"
#include "weavefront/solver/load_watch.hpp"
#include "weavefront/solver/outcome.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::app {

namespace {

// However seldom rows are written, a run that has gone wrong is not computed to its end; the balance costs about as much as a step.
constexpr std::int64_t steps_between_balances = 1000;

/// Times 0, interval, 2 interval, ...: each is due at the first step at or after it.
class Schedule {
  public:
    explicit Schedule(double interval) : interval_(interval) {}

    /// True once for every time passed.
    bool due(double time) {
        if (time < next_ * interval_ || next_ < 0) return false;
        next_ = interval_ > 0 ? std::floor(time / interval_) + 1 : -1;
        return true;
    }

  private:
    double interval_, next_ = 0;
};

}  // namespace

class Impact::Parts {
  public:
    Parts(const scene::Scene& scene, const std::filesystem::path& directory, const parallel::Communicator& comm, io::Terminal terminal,
          std::optional<double> rebalance)
        : scene_(scene),
          comm_(comm),
          directory_(directory),
          log_(directory, comm, terminal),
          report_(scene, comm, log_),
          simulation_(scene, comm),
          history_(directory / "history.csv", comm),
          results_(setup(), comm),
          rows_(scene.output.history),
          frames_(scene.output.interval) {
        if (rebalance) load_.emplace(scene, *rebalance);
    }

    std::optional<std::string> to_the_end() {
        report_.start(simulation_);
        std::optional<std::string> stopped;
        io::Progress progress(log_, scene_.time.end);
        try {
            advance(progress);
        } catch (const solver::GuardStop& stop) {
            stopped = stop.what();
        } catch (const io::NotFinite& refused) {
            stopped = refused.what();
        } catch (const io::FileError& failure) {
            log_.record(
                fmt::format("Ended at t = {:.6g} us after {} steps: {}", simulation_.time() * 1e6, simulation_.steps(), failure.what()));
            report_.record_end();
            throw;
        }
        try {
            if (stopped) write_frame();
        } catch (const io::NotFinite& refused) {
            *stopped += std::string("; ") + refused.what();
        }
        progress.finish();
        if (load_ && !is_rebalanced_) report_.never_rebalanced(load_->worst());
        report_.finish(simulation_, last_, stopped, directory_);
        return stopped;
    }

  private:
    void advance(io::Progress& progress) {
        for (;;) {
            simulation_.advance_forces();
            const bool end = simulation_.time() >= scene_.time.end;
            if (rows_.due(simulation_.time()) || end) {
                write_row();
            } else if (simulation_.steps() - balanced_ >= steps_between_balances) {
                last_ = simulation_.balance();
                require_balance();
            }
            const bool is_last = end || (balanced_ == simulation_.steps() && is_decided());
            if (frames_.due(simulation_.time()) || is_last) write_frame();
            if (is_last) return;
            simulation_.integrate();
            if (load_) rebalance();
            progress.update(simulation_.time(), simulation_.steps(), report_.projectile_text(simulation_));
        }
    }

    [[nodiscard]] bool is_decided() const { return scene_.time.stop == scene::Stop::decided && solver::is_settled(simulation_, last_); }

    void rebalance() {
        const auto better = load_->look(simulation_, comm_);
        if (!better) return;
        simulation_.redistribute(better->decomposition);
        results_.redistribute(topology_of(simulation_));
        report_.rebalanced(simulation_, *better);
        is_rebalanced_ = true;
    }

    void write_row() {
        last_ = simulation_.balance();
        {
            const solver::Timed timed(simulation_.seconds(), solver::Phase::output);
            history_.write(row_of(last_, simulation_.panel().columns()));
        }
        require_balance();
    }

    void require_balance() {
        balanced_ = simulation_.steps();
        solver::require_balance(last_, scene_.limits.energy_error, simulation_.steps());
    }

    void write_frame() {
        const solver::Timed timed(simulation_.seconds(), solver::Phase::output);
        results_.write(frame_of(simulation_, scene_.output.fields));
    }

    [[nodiscard]] io::ResultsSetup setup() {
        const double interval = scene_.output.interval;
        // First and last frame, those in between, and one for a run stopped by the guard.
        const auto most = (interval > 0 ? static_cast<std::int64_t>(std::ceil(scene_.time.end / interval)) : 0) + 3;
        return {directory_ / "results.vtkhdf",
                topology_of(simulation_),
                projectile_surface(scene_),
                frame_of(simulation_, scene_.output.fields),
                most,
                scene_.resolved,
                WEAVEFRONT_VERSION};
    }

    const scene::Scene& scene_;
    const parallel::Communicator& comm_;
    std::filesystem::path directory_;
    io::Log log_;
    RunReport report_;
    solver::Simulation simulation_;
    io::History history_;
    io::Results results_;
    Schedule rows_, frames_;
    std::optional<solver::LoadWatch> load_;
    solver::Balance last_;
    std::int64_t balanced_ = 0;  // step
    bool is_rebalanced_ = false;
};

Impact::Impact(const scene::Scene& scene, const std::filesystem::path& directory, const parallel::Communicator& comm, io::Terminal terminal,
               std::optional<double> rebalance) try
    : parts_(std::make_unique<Parts>(scene, directory, comm, terminal, rebalance)) {
} catch (const solver::GuardStop& stop) {
    throw GuardStop(stop.what());
}

Impact::~Impact() = default;

std::optional<std::string> Impact::to_the_end() { return parts_->to_the_end(); }

int columns_of(const scene::Scene& scene) { return static_cast<int>(mesh::make_panel(scene).columns()); }

void require_columns(const scene::Scene& scene, int ranks) {
    const int columns = columns_of(scene);
    if (ranks > columns)
        throw scene::InputError({fmt::format("{} ranks for a target of {} columns: use at most that many", ranks, columns)});
}

}  // namespace weavefront::app
