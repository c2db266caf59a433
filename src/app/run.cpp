#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "commands.hpp"
#include "impact.hpp"
#include "launcher.hpp"
#include "memory.hpp"
#include "restart.hpp"
#include "shared_text.hpp"
#include "stop.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

/// Rank 0 reads the file; all ranks parse the same text and so find the same faults.
scene::Scene read_on_root(const RunOptions& options, const parallel::Communicator& comm) {
    return scene::parse_scene(shared_text(options.scene, comm), options.scene.string(), options.overrides,
                              scene::Need::impact, shared_files(comm));
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

io::Earlier treatment_of_earlier(const RunOptions& options) {
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
std::string command_to_go_on(const RunOptions& options, const std::filesystem::path& path) {
    auto command = fmt::format("weavefront run {} --output {} --restart auto", quoted(options.scene.string()),
                               quoted(path.string()));
    for (const auto& text : options.overrides) command += " --set " + quoted(text);
    return command;
}

}  // namespace

void run(const RunOptions& options) {
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

}  // namespace weavefront::app
