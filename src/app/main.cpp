#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "commands.hpp"
#include "launcher.hpp"
#include "usage.hpp"
#include "weavefront/scene/read.hpp"

namespace {

using namespace weavefront;

enum Status : int { done = 0, stopped = 1, bad_input = 2, system_error = 3 };

Status report(Status status, const std::vector<std::string>& messages) {
    // The launcher kills the first rank when another one fails; what all ranks find alike is its to tell, and it is given time to print.
    if (!app::is_first_process()) {
        if (status != system_error) return done;
        std::this_thread::sleep_for(std::chrono::seconds(1));
        return status;
    }
    for (const std::string& message : messages) fmt::print(stderr, "weavefront: error: {}\n", message);
    return status;
}

void add_commands(CLI::App& app) {
    app.set_version_flag("--version", "weavefront " WEAVEFRONT_VERSION);
    app.footer("Exit status: 0 done, 1 stopped by the physics or numerics guard, 2 bad input or usage, 3 system error.");
    app.require_subcommand(1);
    app::add_run(app);
    app::add_check(app);
    app::add_cell(app);
    app::add_yarn(app);
    app::add_study(app);
    app::add_partition(app);
}

Status run(CLI::App& app, int argc, char** argv) {
    try {
        app::refuse_unknown(app, std::vector<std::string>(argv + 1, argv + argc));
        app.parse(argc, argv);
        return done;
    } catch (const CLI::ParseError& error) {
        const bool served = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);  // --help, --version
        if (!served) return report(bad_input, {std::string(error.what()) + " (see weavefront --help)"});
        if (app::is_first_process()) app.exit(error);
        return done;
    } catch (const scene::InputError& error) {
        return report(bad_input, error.shown());
    } catch (const app::GuardStop& stop) {
        return report(stopped, {stop.what()});
    } catch (const std::bad_alloc&) {
        return report(system_error, {"out of memory"});
    } catch (const std::exception& error) {
        return report(system_error, {error.what()});
    } catch (...) {
        return report(system_error, {"unknown exception"});
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Ballistic impact on woven-fabric armour", "weavefront");
    add_commands(app);
    return run(app, argc, argv);
}
