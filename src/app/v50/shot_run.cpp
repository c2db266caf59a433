#include "shot_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "impact.hpp"
#include "rank_groups.hpp"
#include "restart.hpp"
#include "signals.hpp"
#include "stop.hpp"
#include "weavefront/io/checkpoint.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/study/rank_plan.hpp"

namespace weavefront::app {

namespace {

/// How a shot has ended on the ranks that computed it.
struct ShotEnd {
    std::string failure;
    bool is_stopped_by_guard = false, is_interrupted = false;
};

/// The checkpoint of an interrupted shot; none: it begins anew. @note Collective
std::optional<Restart> restart_of(const scene::Scene& scene, const std::filesystem::path& path,
                                  const parallel::Communicator& comm) {
    bool is_there = false;
    parallel::on_root(comm, [&] {
        const auto newest = checkpoint_in(path);
        is_there =
            std::filesystem::exists(newest) || std::filesystem::exists(io::previous_checkpoint(newest));
    });
    if (!comm.any(is_there)) return std::nullopt;
    try {
        return find_restart("auto", path, scene, comm);
    } catch (const scene::InputError&) {
        return std::nullopt;  // damaged, or of another version
    }
}

void compute_shot(const scene::Scene& scene, const std::filesystem::path& path,
                  const parallel::Communicator& comm, const CheckpointPlan& checkpoints) {
    const auto restart = restart_of(scene, path, comm);
    io::OutputDirectory directory(path, comm, restart ? io::Earlier::continued : io::Earlier::replaced);
    const auto ending = Impact(scene, directory, comm,
                               {.terminal = io::Terminal::silent,
                                .checkpoints = checkpoints,
                                .restart = restart ? &*restart : nullptr})
                            .run();
    if (ending.kind == Ending::Kind::interrupted) throw Interrupted(ending.reason);
}

ShotEnd end_of_shot(const V50Plan& plan, const ShotRow& row, const std::filesystem::path& folder,
                    const parallel::Communicator& comm) {
    ShotEnd end;
    try {
        compute_shot(plan.scene_of(row.variant, row.number, row.speed), folder / row.folder, comm,
                     plan.checkpoints);
    } catch (const Interrupted&) {
        end.is_interrupted = true;
    } catch (const GuardStop& stop) {
        end = {stop.what(), true, false};  // before the first step
    } catch (const std::exception& error) {
        end.failure = parallel::text_of(error);
    }
    // All ranks of the group fail alike, or else end; other groups go on.
    parallel::meet(comm, end.failure);
    return end;
}

}  // namespace

void compute_shots(const V50Plan& plan, std::span<ShotRow> rows, const std::filesystem::path& folder,
                   const parallel::Communicator& comm, const std::function<void(const ShotRow&)>& told) {
    const int groups = std::min<int>(plan.groups, static_cast<int>(rows.size()));
    std::vector<ShotEnd> ends(rows.size());
    bool is_interrupted = false;
    {
        const int mine = study::group_of(comm.rank(), comm.size(), groups);
        const auto group = split(comm, mine);
        const bool takes_part = group.rank() < plan.columns;
        const auto part = split(group, takes_part ? 0 : 1);
        for (auto i = static_cast<std::size_t>(mine); i < rows.size() && takes_part;
             i += static_cast<std::size_t>(groups)) {
            if (is_interrupted || part.any(noted_signal() != 0)) {
                is_interrupted = true;
                break;
            }
            ends[i] = end_of_shot(plan, rows[i], folder, part);
            is_interrupted = ends[i].is_interrupted;
            if (part.rank() == 0 && !is_interrupted) told(rows[i]);
        }
    }
    parallel::meet(comm);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto failure = parallel::first_failure(comm, ends[i].failure);
        const bool is_stopped = comm.any(ends[i].is_stopped_by_guard);
        if (failure.empty()) continue;
        rows[i].is_done = true;
        rows[i].reason = failure;
        rows[i].is_stopped_by_guard = is_stopped;
        rows[i].is_failed = !is_stopped;
        rows[i].outcome = is_stopped ? "stopped" : "failed";
    }
    if (comm.any(is_interrupted)) throw Interrupted("shots were interrupted");
}

}  // namespace weavefront::app
