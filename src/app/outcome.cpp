#include "outcome.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "launcher.hpp"
#include "stop.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::app {

namespace {

std::string text_of(const Outcome& outcome) { return fmt::format("{}", fmt::join(outcome.messages, "\n")); }

std::vector<std::function<void()>>& end_actions() {
    static std::vector<std::function<void()>> actions;
    return actions;
}

}  // namespace

Outcome outcome_of(const std::function<void()>& action) {
    try {
        action();
        return {};
    } catch (const scene::InputError& error) {
        return {Status::bad_input, error.shown()};
    } catch (const GuardStop& stop) {
        return {Status::stopped, {stop.what()}};
    } catch (const solver::GuardStop& stop) {
        return {Status::stopped, {stop.what()}};
    } catch (const Interrupted& end) {
        return {Status::interrupted, {end.what()}};
    } catch (const std::exception& error) {
        return {Status::system_error, {parallel::text_of(error)}};
    } catch (...) {
        return {Status::system_error, {"unknown exception"}};
    }
}

int report(const Outcome& outcome) {
    if (!is_first_process()) {
        // What all processes find alike is for the first one to tell. The launcher kills it when another one
        // fails: it is given time to print.
        if (outcome.status != Status::done) std::this_thread::sleep_for(std::chrono::seconds(1));
        return static_cast<int>(outcome.status);
    }
    for (const std::string& message : outcome.messages)
        fmt::print(stderr, "weavefront: error: {}\n", message);
    return static_cast<int>(outcome.status);
}

int report_together(const Outcome& outcome, const parallel::Communicator& comm) {
    if (comm.size() == 1) return report(outcome);
    const bool is_failed = outcome.status != Status::done;
    const std::string text = text_of(outcome);
    parallel::meet(comm, is_failed ? text : "");
    const std::string of_first = comm.broadcast(text);
    if (comm.any(is_failed && text != of_first)) {
        if (is_failed) parallel::tell_failure(text);
        parallel::meet(comm);
        parallel::end_all_ranks();
    }
    // The launcher may kill the first rank, and lose what it has printed, when another one fails.
    return comm.rank() == 0 ? report(outcome) : static_cast<int>(Status::done);
}

void require_same_arguments(const std::vector<std::string>& arguments, const parallel::Communicator& comm) {
    const auto mine =
        fmt::format("weavefront {} of version {}", fmt::join(arguments, " "), WEAVEFRONT_VERSION);
    const auto of_first = comm.broadcast(mine);
    const auto difference = parallel::first_failure(
        comm, mine == of_first
                  ? ""
                  : fmt::format("the ranks were started differently: rank {} as {}, rank 0 as {}",
                                comm.rank(), mine, of_first));
    if (!difference.empty()) throw scene::InputError({difference});
}

void run_at_end(std::function<void()> action) { end_actions().push_back(std::move(action)); }

void run_end() {
    for (const auto& action : end_actions()) action();
}

}  // namespace weavefront::app
