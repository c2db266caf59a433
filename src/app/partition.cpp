#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "commands.hpp"
#include "impact.hpp"
#include "launcher.hpp"
#include "list_option.hpp"
#include "output_file.hpp"
#include "partition/calibration.hpp"
#include "partition/cpu_speed.hpp"
#include "partition/machine_file.hpp"
#include "partition/scaling_table.hpp"
#include "partition/spread_ranks.hpp"
#include "shared_text.hpp"
#include "stop.hpp"
#include "weavefront/io/replace_file.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/partition/machine.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::app {

namespace {

constexpr int most_ranks = 100'000;

int rank_count(const std::string& text) {
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 1 || count > most_ranks)
        throw scene::InputError({fmt::format("--ranks: found '{}', allowed a whole number from 1 to {}",
                                             scene::printable(text), most_ranks)});
    return count;
}

std::vector<int> rank_counts(const PartitionOptions& options, const scene::Scene& scene) {
    std::vector<int> ranks;
    for (const auto& text : items_of(*options.ranks)) ranks.push_back(rank_count(text));
    for (const int count : ranks) {
        const int columns = columns_of(scaled_scene(scene, options.weak, count, ranks.front()));
        if (count > columns)
            throw scene::InputError(
                {fmt::format("--ranks: found {}, allowed at most {}, the columns of elements of the target",
                             count, columns)});
    }
    return ranks;
}

void require_consistent(const PartitionOptions& options) {
    if (options.ranks.has_value() != options.calibrate.empty())
        throw scene::InputError({"partition: allowed is one of --ranks LIST and --calibrate FILE"});
    if (options.repetitions < 1)
        throw scene::InputError({fmt::format("--repetitions: found {}, allowed a whole number of at least 1",
                                             options.repetitions)});
}

/// Adds what the steps take here to the rows of as many ranks as there are.
void measure(const PartitionOptions& options, const scene::Scene& scene, const parallel::Communicator& comm,
             std::vector<ScalingRow>& rows, const std::vector<int>& ranks,
             const partition::Machine& machine) {
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (ranks[i] > comm.size()) continue;
        const auto scaled = scaled_scene(scene, options.weak, ranks[i], ranks.front());
        const auto some = first_ranks(comm, ranks[i]);
        compute_apart(comm, some.has_value(), [&] {
            const auto steps = repeat_steps(scaled, *some, *some, options.repetitions);
            if (comm.rank() == 0)
                rows[i].measured = steps.times.mean(),
                rows[i].slowdown = steps.reference_time / machine.reference_time;
        });
    }
}

void scale(const PartitionOptions& options, const scene::Scene& scene, const parallel::Communicator& comm) {
    const auto machine = options.machine.empty()
                             ? partition::committed_machine()
                             : parse_machine(shared_text(options.machine, comm), options.machine.string());
    const auto ranks = rank_counts(options, scene);
    std::vector<ScalingRow> rows;
    parallel::on_root(comm, [&] { rows = forecast_all(scene, options.weak, ranks, machine); });
    if (options.measure) measure(options, scene, comm, rows, ranks, machine);
    if (comm.rank() != 0) return;
    fmt::print("{}\n  machine    {}\n{}", scene.title, machine.name, terminal_table(rows));
    if (!options.out.empty()) io::replace_file(options.out, csv_table(rows));
}

void run_calibration(const PartitionOptions& options, const scene::Scene& scene,
                     const parallel::Communicator& comm) {
    require_calibration(scene, comm.size());
    const auto machine = calibrate(scene, comm, options.repetitions);
    if (comm.rank() != 0) return;
    io::replace_file(options.calibrate, machine_text(machine));
    fmt::print("{}: written\n{}", options.calibrate.string(), machine_text(machine));
}

}  // namespace

void partition(const PartitionOptions& options) {
    require_consistent(options);
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    require_one_job(comm.size());
    const auto scene = scene::parse_scene(shared_text(options.scene, comm), options.scene.string(),
                                          options.overrides, scene::Need::impact, shared_files(comm));
    const bool calibrates = !options.calibrate.empty();
    if (const auto& file = calibrates ? options.calibrate : options.out; !file.empty()) {
        require_other_file(calibrates ? "--calibrate" : "--out", file, {options.scene, options.machine});
        parallel::on_root(comm, [&] { io::require_replaceable(file); });
    }
    try {
        calibrates ? run_calibration(options, scene, comm) : scale(options, scene, comm);
    } catch (const solver::GuardStop& stop) {
        throw GuardStop(stop.what());
    }
}

}  // namespace weavefront::app
