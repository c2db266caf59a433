#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "commands.hpp"
#include "impact.hpp"
#include "launcher.hpp"
#include "memory.hpp"
#include "overrides_option.hpp"
#include "shared_text.hpp"
#include "signals.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

struct Options {
    std::filesystem::path scene, output;
    std::vector<std::string> overrides;
    std::optional<double> rebalance;
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

void run(const Options& options) {
    note_signals();
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    require_one_job(comm.size());
    const auto scene = read_on_root(options, comm);
    require_same_scene(scene, comm);
    require_columns(scene, comm.size());
    require_memory(mesh::make_panel(scene), comm);
    const auto path =
        options.output.empty() ? std::filesystem::path("runs") / options.scene.stem() : options.output;
    io::OutputDirectory directory(path, comm,
                                  options.overwrite ? io::Earlier::replaced : io::Earlier::refused);
    const auto ending = Impact(scene, directory, comm, io::Terminal::shown, options.rebalance).run();
    if (ending.kind == Ending::Kind::stopped) throw GuardStop(ending.reason);
    if (ending.kind == Ending::Kind::interrupted)
        throw Interrupted(fmt::format("{}: {} holds the run up to there", ending.reason, path.string()));
}

}  // namespace

void add_run(CLI::App& app) {
    auto* command = app.add_subcommand("run", "Compute an impact: mpirun -n N weavefront run SCENE");
    auto options = std::make_shared<Options>();
    command->add_option("SCENE", options->scene, "Scene file (YAML)")->required();
    command->add_option(
        "--output", options->output,
        "Folder for history.csv, results.vtkhdf, summary.json and run.log (default: runs/<scene name>)");
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
    command->callback([options] { run(*options); });
}

}  // namespace weavefront::app
