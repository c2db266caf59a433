#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "impact.hpp"
#include "launcher.hpp"
#include "list_option.hpp"
#include "output_file.hpp"
#include "overrides_option.hpp"
#include "partition/calibration.hpp"
#include "partition/cpu_speed.hpp"
#include "partition/machine_file.hpp"
#include "partition/scaling_table.hpp"
#include "partition/spread_ranks.hpp"
#include "shared_text.hpp"
#include "weavefront/io/replace_file.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/partition/machine.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::app {

namespace {

constexpr int most_ranks = 100'000;

struct Options {
    std::filesystem::path scene, machine, out, calibrate;
    std::vector<std::string> overrides;
    std::optional<std::string> ranks;
    bool weak = false, measure = false;
    int repetitions = 3;
};

int rank_count(const std::string& text) {
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 1 || count > most_ranks)
        throw scene::InputError({fmt::format("--ranks: found '{}', allowed a whole number from 1 to {}",
                                             scene::printable(text), most_ranks)});
    return count;
}

std::vector<int> rank_counts(const Options& options, const scene::Scene& scene) {
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

void require_consistent(const Options& options) {
    if (options.ranks.has_value() != options.calibrate.empty())
        throw scene::InputError({"partition: allowed is one of --ranks LIST and --calibrate FILE"});
    if (options.repetitions < 1)
        throw scene::InputError({fmt::format("--repetitions: found {}, allowed a whole number of at least 1",
                                             options.repetitions)});
}

/// Adds what the steps take here to the rows of as many ranks as there are.
void measure(const Options& options, const scene::Scene& scene, const parallel::Communicator& comm,
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

void scale(const Options& options, const scene::Scene& scene, const parallel::Communicator& comm) {
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

void run_calibration(const Options& options, const scene::Scene& scene, const parallel::Communicator& comm) {
    require_calibration(scene, comm.size());
    const auto machine = calibrate(scene, comm, options.repetitions);
    if (comm.rank() != 0) return;
    io::replace_file(options.calibrate, machine_text(machine));
    fmt::print("{}: written\n{}", options.calibrate.string(), machine_text(machine));
}

void partition(const Options& options) {
    require_consistent(options);
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    require_one_job(comm.size());
    const auto scene =
        scene::parse_scene(shared_text(options.scene, comm), options.scene.string(), options.overrides);
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

}  // namespace

void add_partition(CLI::App& app) {
    auto* command =
        app.add_subcommand("partition", "Quality of decompositions and the time of a step that they lead to");
    auto options = std::make_shared<Options>();
    command->add_option("SCENE", options->scene, "Scene file (YAML)")->required();
    command->add_option("--ranks", options->ranks, "Rank counts, such as 1,64,1024");
    command->add_flag("--weak", options->weak,
                      "Refine the mesh with the square root of the rank count from the first one, where the "
                      "scene is as it stands");
    command->add_option("--machine", options->machine,
                        "Constants of a machine, from --calibrate (default: those of the program's own)");
    command->add_flag("--measure", options->measure,
                      "Compute the scene on up to as many ranks as mpirun gives, beside the model");
    command->add_option("--calibrate", options->calibrate,
                        "Measure this machine on the ranks that mpirun gives and write its constants (JSON)");
    command->add_option("--repetitions", options->repetitions,
                        "Of every measured step, of which the quickest counts (default: 3)");
    command->add_option("--out", options->out, "Write the table as CSV");
    add_overrides(*command, options->overrides);
    command->callback([options] { partition(*options); });
}

}  // namespace weavefront::app
