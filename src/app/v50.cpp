#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "commands.hpp"
#include "launcher.hpp"
#include "memory.hpp"
#include "outcome.hpp"
#include "picture.hpp"
#include "run_head.hpp"
#include "stop.hpp"
#include "v50/campaign.hpp"
#include "v50/earlier_v50.hpp"
#include "v50/findings.hpp"
#include "v50/v50_plan.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/io/replace_file.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

/// Refuses variants that do not fit into the memory, where all shots of a round are.
void require_room(const V50Plan& plan, const parallel::Communicator& comm) {
    for (std::size_t i = 0; i < plan.variants.size(); ++i)
        require_memory(mesh::make_panel(plan.scene_of(i, 1, plan.search.start)), comm, plan.groups);
}

void say(const V50Plan& plan, const parallel::Communicator& comm, io::Log& log) {
    log.info(fmt::format("Weavefront {}: limit velocity of {}", WEAVEFRONT_VERSION, plan.title));
    log.info("  shots         end when they are decided; frames: first and last");
    log.info(fmt::format(
        "  ranks         {}: {}", comm.size(),
        plan.groups > 1 ? fmt::format("{} shots side by side", plan.groups) : "one shot at a time"));
    if (plan.scatter.empty())
        log.info("  search        until the bracket is " + plan.unit.text(plan.search.width) + " wide");
    else
        log.info(fmt::format("  design        Neyer, {} shots, V50 guessed from {}, sigma {}", plan.count,
                             plan.unit.text(plan.design.from, plan.design.to),
                             plan.unit.text(plan.design.sigma)));
    if (!plan.range_shots.empty())
        log.info(fmt::format("  range         {} shots added to the fit", plan.range_shots.size()));
}

/// What keeps the command from its end with status 0, after everything has been written.
void raise(const Campaign& campaign) {
    std::vector<std::string> failed;
    for (const auto& row : campaign.rows())
        if (row.is_failed) failed.push_back(fmt::format("{}: {}", row.folder, row.reason));
    if (!failed.empty()) throw std::runtime_error(fmt::format("{}", fmt::join(failed, "; ")));
    for (const auto& failure : campaign.failures()) {
        if (failure.empty()) continue;
        if (failure.starts_with("the limit lies"))
            throw scene::InputError({failure + ": name another with --from or --to"});
        throw GuardStop("no limit was found: " + failure);
    }
}

/// Interrupted shots are kept; the message tells how to go on.
[[noreturn]] void leave(const V50Options& options) {
    throw Interrupted(
        fmt::format("asked to stop: finished shots and checkpoints are kept in {}; to go on, give the same "
                    "command with --restart auto",
                    options.output.string()));
}

/// @returns whether this is the rank that draws
bool compute(const V50Options& options) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    require_one_job(comm.size());
    const auto plan = read_v50_plan(options, comm);
    require_room(plan, comm);
    const io::OutputDirectory kept(options.output, comm, io::Earlier::kept);
    settle_earlier_v50(options, plan, comm);
    io::Log log(options.output, comm, io::Terminal::shown,
                options.restart.empty() ? io::LogStart::anew : io::LogStart::continued);
    log.publish();
    const auto begin = std::chrono::steady_clock::now();
    for (const auto& line : run_head(comm)) log.record(line);
    say(plan, comm, log);
    Campaign campaign(plan, options.output, comm, log);
    try {
        if (!options.restart.empty()) campaign.go_on();
        campaign.shoot();
    } catch (const Interrupted&) {
        leave(options);
    }
    parallel::on_root(comm, [&] {
        const auto findings = find_v50(plan, campaign);
        io::replace_file(options.output / "v50.json", json_of_v50(plan, campaign, findings));
        report_v50(plan, findings, log);
        log.info("  results       " + options.output.string());
        log.record(run_tail(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    });
    raise(campaign);
    return comm.rank() == 0;
}

}  // namespace

void v50(V50Options options) {
    if (options.output.empty())
        options.output = std::filesystem::path("runs") / (options.scene.stem().string() + "_v50");
    if (compute(options) && !options.no_picture)
        run_at_end([folder = options.output] { draw_pictures("--v50", folder); });
}

}  // namespace weavefront::app
