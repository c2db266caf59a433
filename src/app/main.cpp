#include <fmt/format.h>

#include <string>
#include <vector>

#include "commands.hpp"
#include "launcher.hpp"
#include "outcome.hpp"
#include "signals.hpp"
#include "usage.hpp"
#include "weavefront/scene/read.hpp"

namespace {

using namespace weavefront;

void add_commands(CLI::App& app) {
    app.set_version_flag("--version", "weavefront " WEAVEFRONT_VERSION);
    app.footer(
        "Exit status: 0 done, 1 stopped by the physics or numerics guard, 2 bad input or usage, 3 system "
        "error, 4 stopped on request.");
    app.require_subcommand(1);
    app::add_run(app);
    app::add_check(app);
    app::add_cell(app);
    app::add_yarn(app);
    app::add_study(app);
    app::add_partition(app);
}

void run(CLI::App& app, const std::vector<std::string>& arguments) {
    app::refuse_unknown(app, arguments);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(),
                                           arguments.rend()));  // the last one first, as CLI11 takes them
    } catch (const CLI::ParseError& error) {
        const bool is_served =
            error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);  // --help, --version
        if (!is_served) throw scene::InputError({std::string(error.what()) + " (see weavefront --help)"});
        if (weavefront::app::is_first_process()) app.exit(error);
    }
}

/// Several ranks: what one of them meets alone is told, too.
int run_together(CLI::App& app, const std::vector<std::string>& arguments) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto outcome = app::outcome_of([&] {
        app::require_same_arguments(arguments, comm);
        run(app, arguments);
    });
    return app::report_together(outcome, comm);
}

}  // namespace

int main(int argc, char** argv) {
    app::ignore_failed_writes();
    CLI::App app("Ballistic impact on woven-fabric armour", "weavefront");
    add_commands(app);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    // MPI takes a part of a second to start: a signal is not lost meanwhile.
    const bool takes_long =
        !arguments.empty() && (arguments.front() == "run" || arguments.front() == "study");
    if (takes_long) app::note_signals();
    int status = 0;
    const auto outcome = app::outcome_of([&] {
        if (app::launched_processes() > 1)
            status = run_together(app, arguments);
        else
            run(app, arguments);
        app::run_end();
    });
    return outcome.status == app::Status::done ? status : app::report(outcome);
}
