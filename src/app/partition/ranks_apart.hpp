#pragma once
/// @file
/// Some ranks compute while the others leave their cores alone.

#include <exception>
#include <optional>
#include <string>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::app {

/// The first `count` ranks; none on the others. @note Collective
std::optional<parallel::Communicator> first_ranks(const parallel::Communicator& comm, int count);

/// Waits for all ranks asleep: MPI's own barrier would take processor time from those that still compute. @note Collective
void sleep_until_all_arrive(const parallel::Communicator& comm);

/// Runs `action` on some of the ranks, the first among them, while the others sleep.
/// @throws on all ranks what `action` throws on the first one: solver::GuardStop, or else std::runtime_error
/// @note Collective
template <class Action>
void compute_apart(const parallel::Communicator& comm, bool computes, Action action) {
    std::string stopped;
    std::exception_ptr failure;
    try {
        if (computes) action();
    } catch (const solver::GuardStop& stop) {
        stopped = stop.what();
    } catch (...) {
        failure = std::current_exception();
    }
    sleep_until_all_arrive(comm);
    parallel::on_root(comm, [&] {
        if (failure) std::rethrow_exception(failure);
    });
    stopped = comm.broadcast(stopped);
    if (!stopped.empty()) throw solver::GuardStop(stopped);
}

}  // namespace weavefront::app
