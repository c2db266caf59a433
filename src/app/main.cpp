#include <string>
#include <vector>

#include "command_line.hpp"
#include "launcher.hpp"
#include "outcome.hpp"
#include "signals.hpp"

namespace {

using namespace weavefront;

/// Several ranks: what one of them meets alone is told, too.
int execute_together(const std::vector<std::string>& arguments) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto outcome = app::outcome_of([&] {
        app::require_same_arguments(arguments, comm);
        app::execute(arguments);
    });
    return app::report_together(outcome, comm);
}

}  // namespace

int main(int argc, char** argv) {
    app::ignore_failed_writes();
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    // MPI takes a part of a second to start: a signal is not lost meanwhile.
    const bool takes_long =
        !arguments.empty() &&
        (arguments.front() == "run" || arguments.front() == "study" || arguments.front() == "v50");
    if (takes_long) app::note_signals();
    int status = 0;
    const auto outcome = app::outcome_of([&] {
        if (app::launched_processes() > 1)
            status = execute_together(arguments);
        else
            app::execute(arguments);
        app::run_end();
    });
    return outcome.status == app::Status::done ? status : app::report(outcome);
}
