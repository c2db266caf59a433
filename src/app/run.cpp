#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "commands.hpp"
#include "impact.hpp"
#include "launcher.hpp"
#include "memory.hpp"
#include "overrides_option.hpp"
#include "restart.hpp"
#include "shared_text.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/scene/duration.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

struct Options {
    std::filesystem::path scene, output;
    std::vector<std::string> overrides;
    std::optional<double> rebalance;
    CheckpointPlan checkpoints;
    std::string restart;  // empty: from the start
    bool overwrite = false;
};

/// Rank 0 reads the file; all ranks parse the same text and so find the same faults.
scene::Scene read_on_root(const Options& options, const parallel::Communicator& comm) {
    return scene::parse_scene(shared_text(options.scene, comm), options.scene.string(), options.overrides);
}

/// The same text on all ranks; what it says may depend on the libraries of a node.
void require_same_scene(const scene::Scene& scene, const parallel::Communicator& comm) {
    const auto same = comm.broadcast(scene.hash) == scene.hash;
    const auto difference = parallel::first_failure(
        comm, same ? ""
                   : fmt::format("rank {} reads other values in the scene than rank 0: are udunits2 and its "
                                 "database the same on all nodes?",
                                 comm.rank()));
    if (!difference.empty()) throw std::runtime_error(difference);
}

/// @return what is wrong with the text; empty: nothing
std::string read_duration(const std::string& text, std::optional<double>& seconds,
                          const std::string& example) {
    const auto read = scene::duration_of(text);
    if (const auto* problem = std::get_if<std::string>(&read)) return *problem + example;
    if (!(std::get<double>(read) > 0))
        return fmt::format("found '{}', allowed a time above 0{}", text, example);
    seconds = std::get<double>(read);
    return {};
}

/// Reads `10 min` or `5000 steps`. @return what is wrong with it; empty: nothing
std::string read_checkpoint_interval(const std::string& text, CheckpointPlan& plan) {
    std::istringstream words(text);
    std::int64_t count = 0;
    std::string unit, rest;
    if (words >> count >> unit && (unit == "steps" || unit == "step") && !(words >> rest)) {
        if (count <= 0) return fmt::format("found '{}', allowed at least 1 step", text);
        plan.steps = count;
        return {};
    }
    return read_duration(text, plan.interval, ", such as '10 min' or '5000 steps'");
}

io::Earlier treatment_of_earlier(const Options& options) {
    if (!options.restart.empty()) return io::Earlier::continued;
    return options.overwrite ? io::Earlier::replaced : io::Earlier::refused;
}

/// A word as a shell takes it.
std::string quoted(const std::string& word) {
    const bool is_plain = std::ranges::all_of(word, [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("/._-=+:,").find(static_cast<char>(c)) != std::string_view::npos;
    });
    if (is_plain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// What continues an interrupted run, on any number of ranks.
std::string command_to_go_on(const Options& options, const std::filesystem::path& path) {
    auto command = fmt::format("weavefront run {} --output {} --restart auto", quoted(options.scene.string()),
                               quoted(path.string()));
    for (const auto& text : options.overrides) command += " --set " + quoted(text);
    return command;
}

void run(const Options& options) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    require_one_job(comm.size());
    const auto scene = read_on_root(options, comm);
    require_same_scene(scene, comm);
    require_columns(scene, comm.size());
    require_memory(mesh::make_panel(scene), comm);
    const auto path =
        options.output.empty() ? std::filesystem::path("runs") / options.scene.stem() : options.output;
    io::OutputDirectory directory(path, comm, treatment_of_earlier(options));
    std::optional<Restart> restart;
    if (!options.restart.empty()) restart.emplace(find_restart(options.restart, path, scene, comm));
    const auto ending = Impact(scene, directory, comm,
                               {.rebalance = options.rebalance,
                                .checkpoints = options.checkpoints,
                                .restart = restart ? &*restart : nullptr})
                            .run();
    if (ending.kind == Ending::Kind::stopped) throw GuardStop(ending.reason);
    if (ending.kind == Ending::Kind::interrupted)
        throw Interrupted(fmt::format("{}: a checkpoint was written; to go on: {}", ending.reason,
                                      command_to_go_on(options, path)));
}

}  // namespace

void add_run(CLI::App& app) {
    auto* command = app.add_subcommand("run", "Compute an impact: mpirun -n N weavefront run SCENE");
    auto options = std::make_shared<Options>();
    command->add_option("SCENE", options->scene, "Scene file (YAML)")->required();
    command->add_option(
        "--output", options->output,
        "Folder for history.csv, results.vtkhdf, summary.json and run.log (default: runs/<scene name>)");
    auto* overwrite =
        command->add_flag("--overwrite", options->overwrite,
                          "Replace an earlier run in the folder, when the new one is certain to start");
    add_overrides(*command, options->overrides);
    command
        ->add_option("--rebalance", options->rebalance,
                     "Move columns between the ranks whenever the slowest stays above the mean by more than "
                     "this share; 0.1 is 10 %")
        ->check([](const std::string& text) {
            double share = -1;
            const bool number = CLI::detail::lexical_cast(text, share) && share >= 0 && std::isfinite(share);
            return number ? std::string()
                          : "found '" + text + "', allowed a number of at least 0, such as 0.1 for 10 %";
        });
    command->add_option_function<std::string>(
        "--checkpoint-every",
        [options](const std::string& text) {
            const auto problem = read_checkpoint_interval(text, options->checkpoints);
            if (!problem.empty()) throw CLI::ValidationError("--checkpoint-every", problem);
        },
        "Write a checkpoint after so much wall time or so many steps: '10 min', '5000 steps'");
    command->add_option_function<std::string>(
        "--walltime",
        [options](const std::string& text) {
            const auto problem = read_duration(text, options->checkpoints.walltime, ", such as '2 h'");
            if (!problem.empty()) throw CLI::ValidationError("--walltime", problem);
        },
        "Write a checkpoint and leave before this wall time is over; the end of a Slurm job is found by "
        "itself");
    command
        ->add_option("--restart", options->restart,
                     "Go on from a checkpoint: auto (the newest whole one in the output folder) or a file")
        ->excludes(overwrite);
    command->callback([options] { run(*options); });
}

}  // namespace weavefront::app
