#include "impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "commands.hpp"
#include "frames.hpp"
#include "projectile_surface.hpp"
#include "run_report.hpp"
#include "signals.hpp"
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

// However seldom rows are written, a run that has gone wrong is not computed to its end; the balance costs
// about as much as a step.
constexpr std::int64_t steps_between_balances = 1000;

// A launcher that has passed on a signal to end may leave a second: so many bytes of results are copied
// within it.
constexpr double quick_to_cut = 2e8;

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

class Impact::Run {
  public:
    Run(const scene::Scene& scene, io::OutputDirectory& directory, const parallel::Communicator& comm,
        io::Terminal terminal, std::optional<double> rebalance)
        : scene_(scene),
          comm_(comm),
          directory_(directory),
          log_(directory.path(), comm, terminal),
          report_(scene, comm, log_),
          simulation_(scene, comm),
          history_(directory.path() / "history.csv", comm),
          results_(setup(), comm),
          rows_(scene.output.history),
          frames_(scene.output.interval) {
        if (rebalance) load_.emplace(scene, *rebalance);
    }

    Ending run() {
        publish();
        Ending ending;
        io::Progress progress(log_, scene_.time.end);
        try {
            ending = advance(progress);
        } catch (const solver::GuardStop& stop) {
            ending = {Ending::Kind::stopped, stop.what()};
        } catch (const io::NotFinite& refused) {
            ending = {Ending::Kind::stopped, refused.what()};
        } catch (const io::FileError& failure) {
            log_.record(fmt::format("Ended at t = {:.6g} us after {} steps: {}", simulation_.time() * 1e6,
                                    simulation_.steps(), failure.what()));
            report_.record_end();
            throw;
        }
        if (ending.kind == Ending::Kind::stopped) write_last_good_frame(ending.reason);
        progress.finish();
        if (load_ && !is_rebalanced_) report_.never_rebalanced(load_->worst());
        report_.finish(simulation_, last_, ending, directory_.path(), history_.hash());
        const bool is_to_be_cut = ending.kind != Ending::Kind::interrupted || results_.bytes() < quick_to_cut;
        if (is_to_be_cut && !results_.cut())
            log_.warn(
                "results.vtkhdf keeps room for more frames: the disk cannot hold a shorter copy beside it");
        return ending;
    }

  private:
    /// The new run is certain to start: its files take the place of those of an earlier one.
    void publish() {
        if (comm_.any(noted_signal() != 0))
            throw Interrupted(agreed_signal() + " received before the first step: nothing was written");
        const auto replaced = directory_.clear();
        log_.publish();
        history_.publish();
        results_.publish();
        report_.start(simulation_);
        if (!replaced.empty()) log_.info(fmt::format("  replaces      {}", fmt::join(replaced, ", ")));
    }

    /// Name of a signal that ranks have received. @note Collective
    [[nodiscard]] std::string agreed_signal() const {
        return name_of_signal(static_cast<int>(comm_.max(noted_signal())));
    }

    [[nodiscard]] bool is_at_end() const { return simulation_.time() >= scene_.time.end; }

    Ending advance(io::Progress& progress) {
        for (;;) {
            if (noted_signal() != 0) simulation_.request_stop();
            simulation_.advance_forces();
            const bool end = is_at_end() || simulation_.is_stop_agreed();
            if (rows_.due(simulation_.time()) || end) {
                write_row();
            } else if (simulation_.steps() - balanced_ >= steps_between_balances) {
                last_ = simulation_.record_balance();
                require_balance();
            }
            const bool is_last = end || (balanced_ == simulation_.steps() && is_decided());
            if (frames_.due(simulation_.time()) || is_last) write_frame();
            if (is_last) return ending_now();
            simulation_.integrate();
            if (load_) rebalance();
            progress.update(simulation_.time(), simulation_.steps(), report_.projectile_text(simulation_));
        }
    }

    [[nodiscard]] bool is_decided() const {
        return scene_.time.stop == scene::Stop::decided && solver::is_settled(simulation_, last_);
    }

    [[nodiscard]] Ending ending_now() const {
        if (is_at_end()) return {Ending::Kind::finished, "end time reached"};
        if (is_decided()) return {Ending::Kind::finished, "the outcome is decided"};
        return {Ending::Kind::interrupted, agreed_signal() + " received"};
    }

    void rebalance() {
        const auto better = load_->look(simulation_, comm_);
        if (!better) return;
        simulation_.redistribute(better->decomposition);
        results_.redistribute(topology_of(simulation_));
        report_.rebalanced(simulation_, *better);
        is_rebalanced_ = true;
    }

    void write_row() {
        last_ = simulation_.record_balance();
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
        history_.require_in_place();
        results_.write(frame_of(simulation_, scene_.output.fields));
        last_frame_ = simulation_.time();
    }

    /// The state at which the guard has stopped the run, unless it is not finite, which is added to the
    /// reason then.
    void write_last_good_frame(std::string& reason) {
        try {
            write_frame();
        } catch (const io::NotFinite& refused) {
            if (reason != refused.what()) reason += std::string("; ") + refused.what();
            reason += results_.frames() > 0
                          ? fmt::format("; the last frame is that of t = {:.6g} us", last_frame_ * 1e6)
                          : "; no frame was written";
        }
    }

    /// Frames at the first step at or after each output time, and at the end: not more than there are steps.
    /// Where steps become so much shorter that there are more, the file gets more room.
    [[nodiscard]] std::int64_t expected_frames() const {
        constexpr double rounding = 1e-6, shorter_steps = 1.5;
        const double end = scene_.time.end, interval = scene_.output.interval;
        const double times = interval > 0 ? std::ceil(end / interval - rounding) : 1;
        return static_cast<std::int64_t>(
                   std::min(times, std::ceil(shorter_steps * end / simulation_.time_step()))) +
               1;
    }

    [[nodiscard]] io::ResultsSetup setup() {
        return {directory_.path() / "results.vtkhdf",
                topology_of(simulation_),
                projectile_surface(scene_),
                frame_of(simulation_, scene_.output.fields),
                expected_frames(),
                scene_.resolved,
                WEAVEFRONT_VERSION};
    }

    const scene::Scene& scene_;
    const parallel::Communicator& comm_;
    io::OutputDirectory& directory_;
    io::Log log_;
    RunReport report_;
    solver::Simulation simulation_;
    io::History history_;
    io::Results results_;
    Schedule rows_, frames_;
    std::optional<solver::LoadWatch> load_;
    solver::Balance last_;
    std::int64_t balanced_ = 0;  // step
    double last_frame_ = 0;      // time, s
    bool is_rebalanced_ = false;
};

Impact::Impact(const scene::Scene& scene, io::OutputDirectory& directory, const parallel::Communicator& comm,
               io::Terminal terminal, std::optional<double> rebalance) try
    : run_(std::make_unique<Run>(scene, directory, comm, terminal, rebalance)) {
} catch (const solver::GuardStop& stop) {
    throw GuardStop(stop.what());
}

Impact::~Impact() = default;

Ending Impact::run() { return run_->run(); }

int columns_of(const scene::Scene& scene) { return static_cast<int>(mesh::make_panel(scene).columns()); }

void require_columns(const scene::Scene& scene, int ranks) {
    const int columns = columns_of(scene);
    if (ranks > columns)
        throw scene::InputError(
            {fmt::format("{} ranks for a target of {} columns: use at most that many", ranks, columns)});
}

}  // namespace weavefront::app
