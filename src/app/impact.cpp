#include "impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frames.hpp"
#include "output_schedule.hpp"
#include "projectile_surface.hpp"
#include "run_report.hpp"
#include "signals.hpp"
#include "stop.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/history.hpp"
#include "weavefront/io/progress.hpp"
#include "weavefront/io/results.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/failure.hpp"
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

}  // namespace

class Impact::Run {
  public:
    Run(const scene::Scene& scene, io::OutputDirectory& directory, const parallel::Communicator& comm,
        const ImpactOptions& options)
        : scene_(scene),
          comm_(comm),
          directory_(directory),
          log_(directory.path(), comm, options.terminal,
               options.restart ? io::LogStart::continued : io::LogStart::anew),
          report_(scene, comm, log_),
          surfaces_(projectile_surfaces(scene)),
          simulation_(scene, comm),
          rows_(scene.output.history),
          frames_(scene.output.interval),
          checkpoints_(options.checkpoints, directory.path(), checkpoint_bytes()),
          restart_(options.restart) {
        if (options.rebalance) load_.emplace(scene, *options.rebalance);
        const auto history = directory.path() / "history.csv";
        if (restart_) {
            const auto [written, frames] = restore(restart_->checkpoint);
            history_.emplace(history, written, comm);
            results_.emplace(setup(), frames, comm);
        } else {
            history_.emplace(history, history_layout(simulation_), comm);
            results_.emplace(setup(), comm);
        }
    }

    Ending run() {
        publish();
        Ending ending;
        io::Progress progress(log_, scene_.time.end);
        try {
            ending = advance(progress);
        } catch (const solver::GuardStop& stop) {
            ending = stopped(stop.what(), stop.fault());
        } catch (const io::NotFinite& refused) {
            ending = stopped(refused.what(), solver::Fault::not_finite);
        } catch (const io::FileError& failure) {
            log_.record(fmt::format("Ended at t = {:.6g} us after {} steps: {}", simulation_.time() * 1e6,
                                    simulation_.steps(), failure.what()));
            report_.record_end();
            throw;
        }
        if (ending.kind == Ending::Kind::stopped) write_last_good_frame(ending.reason);
        progress.finish();
        if (load_ && !is_rebalanced_) report_.never_rebalanced(load_->worst());
        // A run that goes on needs the room.
        if (ending.kind != Ending::Kind::interrupted && !results_->cut())
            log_.warn(
                "results.vtkhdf keeps room for more frames: the disk cannot hold a shorter copy beside it");
        results_.reset();  // what is hashed is complete
        report_.finish(simulation_, last_, ending, directory_.path(), history_->hash());
        return ending;
    }

  private:
    /// The new run is certain to start: its files take the place of those of an earlier one, or go on.
    void publish() {
        if (comm_.any(noted_signal() != 0))
            throw Interrupted(agreed_signal() + " received before the first step: nothing was written");
        std::vector<std::string> replaced;
        if (restart_) {
            directory_.remove_summary();
            io::adopt_checkpoint(restart_->path, checkpoint_in(directory_.path()), comm_);
        } else {
            replaced = directory_.clear();
        }
        log_.publish();
        history_->publish();
        results_->publish();
        report_.start(simulation_);
        if (!replaced.empty()) log_.info(fmt::format("  replaces      {}", fmt::join(replaced, ", ")));
        if (restart_) report_.restarted(simulation_, restart_->path, restart_->passed_over);
    }

    /// Name of a signal that ranks have received. @note Collective
    [[nodiscard]] std::string agreed_signal() const {
        return name_of_signal(static_cast<int>(comm_.max(noted_signal())));
    }

    [[nodiscard]] bool is_at_end() const { return simulation_.time() >= scene_.time.end; }

    Ending advance(io::Progress& progress) {
        for (;;) {
            request();
            simulation_.advance_forces();
            const bool end = is_at_end();
            if (rows_.due(simulation_.time()) || end) {
                write_row();
            } else if (simulation_.steps() - balanced_ >= steps_between_balances) {
                last_ = simulation_.record_balance();
                require_balance();
            }
            require_in_place();
            const bool is_last = end || (balanced_ == simulation_.steps() && is_decided());
            if (frames_.due(simulation_.time()) || is_last) write_frame();
            if (is_last) return {Ending::Kind::finished, end ? "end time reached" : "the outcome is decided"};
            simulation_.integrate();
            if (load_) rebalance();
            const bool leaves = simulation_.is_stop_agreed();
            if (leaves || simulation_.is_checkpoint_agreed() || checkpoints_.is_due_at(simulation_.steps()))
                write_checkpoint();
            if (leaves) return leave();
            progress.update(simulation_.time(), simulation_.steps(), RunReport::projectile_text(simulation_));
        }
    }

    /// What the guard has found, with the place and the cause. @note Collective
    [[nodiscard]] Ending stopped(const std::string& reason, solver::Fault fault) const {
        return {Ending::Kind::stopped, fmt::format("{}; {}", reason, simulation_.diagnosis(fault))};
    }

    /// Asks the other ranks for what this one knows of: signals, and on the first rank the clock.
    void request() {
        if (noted_signal() != 0) simulation_.request_stop();
        if (comm_.rank() != 0) return;
        if (reason_.empty()) reason_ = checkpoints_.reason_to_stop();
        if (!reason_.empty()) simulation_.request_stop();
        if (checkpoints_.is_due()) simulation_.request_checkpoint();
    }

    /// The last row and frame of a run that has to go; the checkpoint knows nothing of them.
    Ending leave() {
        simulation_.advance_forces();
        write_row();
        write_frame();
        const auto by_clock = comm_.broadcast(reason_);
        const auto reason = comm_.any(noted_signal() != 0) ? agreed_signal() + " received" : by_clock;
        return {Ending::Kind::interrupted, reason};
    }

    [[nodiscard]] bool is_decided() const {
        return scene_.time.stop == scene::Stop::decided && solver::is_settled(simulation_, last_);
    }

    void rebalance() {
        const auto better = load_->look(simulation_, comm_);
        if (!better) return;
        simulation_.redistribute(better->decomposition);
        results_->redistribute(topology_of(simulation_));
        report_.rebalanced(simulation_, *better);
        is_rebalanced_ = true;
    }

    /// Not only when the next frame is due, which may be days later.
    void require_in_place() {
        if (simulation_.steps() - looked_ < steps_between_balances) return;
        history_->require_in_place();
        looked_ = simulation_.steps();
    }

    void write_row() {
        last_ = simulation_.record_balance();
        {
            const solver::Timed timed(simulation_.seconds(), solver::Phase::output);
            history_->write(row_of(last_, simulation_.panel().columns()));
        }
        require_balance();
    }

    void require_balance() {
        balanced_ = simulation_.steps();
        solver::require_balance(last_, scene_.limits.energy_error, simulation_.steps());
    }

    void write_frame() {
        const solver::Timed timed(simulation_.seconds(), solver::Phase::output);
        history_->require_in_place();
        results_->write(frame_of(simulation_, surfaces_, scene_.output.fields));
        last_frame_ = simulation_.time();
    }

    /// The state at which the guard has stopped the run, unless it is not finite, which is added to the
    /// reason then.
    void write_last_good_frame(std::string& reason) {
        try {
            write_frame();
        } catch (const io::NotFinite& refused) {
            if (!reason.starts_with(refused.what())) reason += std::string("; ") + refused.what();
            reason += results_->frames() > 0
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

    /// What a checkpoint takes, about.
    [[nodiscard]] double checkpoint_bytes() const {
        std::array<std::int64_t, 1> bytes{static_cast<std::int64_t>(simulation_.model().bytes())};
        comm_.sum(bytes);
        return static_cast<double>(bytes[0]);
    }

    /// State of what is written, beside that of the simulation.
    template <class Archive>
    void visit_output(Archive& archive, io::Written& written, std::int64_t& frames) {
        archive("output.history.bytes", written.bytes);
        archive("output.history.sha256", written.sha256);
        archive("output.frames", frames);
        archive("output.last_frame", last_frame_);
        archive("output.balanced", balanced_);
        const double asked = simulation_.last_time();
        rows_.state(archive, "output.rows", asked);
        frames_.state(archive, "output.frame_times", asked);
    }

    void write_checkpoint() {
        const solver::Timed timed(simulation_.seconds(), solver::Phase::output);
        const auto start = std::chrono::steady_clock::now();
        history_->require_in_place();
        auto written = history_->written();
        auto frames = results_->frames();
        results_->sync();
        auto saved = simulation_.save();
        state::ValueWriter archive(saved.values, comm_);
        visit_output(archive, written, frames);
        const auto& global = simulation_.model().global;
        const auto path = checkpoint_in(directory_.path());
        io::write_checkpoint(
            path,
            {scene_.resolved, WEAVEFRONT_VERSION, std::move(saved.values), std::move(saved.nodes),
             std::move(saved.elements), global.nodes, global.elements},
            comm_);
        const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        checkpoints_.written(seconds);
        report_.checkpoint_written(simulation_, path, seconds);
    }

    /// Brings simulation and output to where a checkpoint has left them.
    std::pair<io::Written, std::int64_t> restore(const io::Checkpoint& checkpoint) {
        io::Written written;
        std::int64_t frames = 0;
        std::string failure;
        try {
            const auto& model = simulation_.model();
            simulation_.restore({checkpoint.values(), checkpoint.nodes(model.nodes.ids),
                                 checkpoint.elements(model.global.element_ids)});
            state::ValueReader archive(checkpoint.values(), comm_);
            visit_output(archive, written, frames);
        } catch (const state::Mismatch& mismatch) {
            failure = restart_->path.string() + " is of no use: " + mismatch.what();
        }
        failure = parallel::first_failure(comm_, failure);
        if (!failure.empty()) throw io::FileError(failure);
        if (is_at_end())
            throw scene::InputError(
                {fmt::format("--restart: time.end: found {:.6g} us, allowed is a time after that of {}, "
                             "{:.6g} us",
                             scene_.time.end * 1e6, restart_->path.string(), simulation_.time() * 1e6)});
        return {written, frames};
    }

    [[nodiscard]] io::ResultsSetup setup() {
        return {directory_.path() / "results.vtkhdf",
                topology_of(simulation_),
                surfaces_.all,
                frame_of(simulation_, surfaces_, scene_.output.fields),
                expected_frames(),
                scene_.resolved,
                WEAVEFRONT_VERSION};
    }

    const scene::Scene& scene_;
    const parallel::Communicator& comm_;
    io::OutputDirectory& directory_;
    io::Log log_;
    RunReport report_;
    ProjectileSurfaces surfaces_;
    solver::Simulation simulation_;
    OutputSchedule rows_, frames_;
    CheckpointSchedule checkpoints_;
    const Restart* restart_;
    std::optional<io::History> history_;
    std::optional<io::Results> results_;
    std::string reason_;  // to stop, as the first rank knows it
    std::optional<solver::LoadWatch> load_;
    solver::Balance last_;
    std::int64_t balanced_ = 0;  // step
    std::int64_t looked_ = 0;    // step at which history.csv was found in its place
    double last_frame_ = 0;      // time, s
    bool is_rebalanced_ = false;
};

Impact::Impact(const scene::Scene& scene, io::OutputDirectory& directory, const parallel::Communicator& comm,
               const ImpactOptions& options) try
    : run_(std::make_unique<Run>(scene, directory, comm, options)) {
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
