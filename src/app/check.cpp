#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "left_out.hpp"
#include "memory.hpp"
#include "warnings.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::app {

namespace {

struct Options {
    std::filesystem::path scene;
    std::vector<std::string> overrides;
};

double print_time_step(const scene::Scene& scene) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_SELF);
    const solver::Simulation simulation(scene, comm);
    fmt::print("  time step  {:.4g} ns\n", simulation.time_step() * 1e9);
    fmt::print("  steps      about {:.0f} to {:.6g} us\n", scene.time.end / simulation.time_step(), scene.time.end * 1e6);
    return simulation.time_step();
}

void check(const Options& options) {
    const auto scene = scene::read_scene(options.scene, options.overrides);
    const auto panel = mesh::make_panel(scene);
    fmt::print("{}: nothing to object to\n", options.scene.string());
    fmt::print("  title      {}\n", scene.title);
    fmt::print("  size       {} elements, {} nodes ({} plies of {} x {} columns, 1/{} of the target)\n", panel.elements(), panel.nodes(),
               panel.plies.size(), panel.columns_x(), panel.columns_y(), panel.multiplicity());
    const double needed = memory_needed(panel.elements());
    fmt::print("  memory     up to {} on all ranks together\n", bytes_text(needed));
    if (needed > memory_here())
        fmt::print("  time step  not computed: the target does not fit into the {} of this machine\n", bytes_text(memory_here()));
    const double time_step = needed > memory_here() ? 0 : print_time_step(scene);
    for (const auto& phrase : left_out(scene, 1)) fmt::print("  left out   {}\n", phrase);
    for (const auto& phrase : warnings(scene, panel, time_step)) fmt::print("warning: {}\n", phrase);
}

}  // namespace

void add_check(CLI::App& app) {
    auto* command = app.add_subcommand("check", "Validate a scene; print its size, memory, time step, steps and what is left out");
    auto options = std::make_shared<Options>();
    command->add_option("SCENE", options->scene, "Scene file (YAML)")->required();
    command->add_option("--set", options->overrides, "Override a value of the scene, PATH=VALUE; may be given several times")
        ->allow_extra_args(false);
    command->callback([options] { check(*options); });
}

}  // namespace weavefront::app
