#pragma once
/// @file
/// Some ranks compute while the others leave their cores alone.

#include <exception>
#include <optional>
#include <stdexcept>
#include <string>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::app {

/// The first `count` ranks; none on the others. @note Collective
std::optional<parallel::Communicator> first_ranks(const parallel::Communicator& comm, int count);

/// Runs `action` on some of the ranks, the first among them, while the others sleep: MPI's own barrier would
/// take processor time from those that compute.
/// @throws on all ranks what `action` throws on any: solver::GuardStop, or else std::runtime_error
/// @note Collective
template <class Action>
void compute_apart(const parallel::Communicator& comm, bool computes, Action action) {
    std::string stopped, failure;
    try {
        if (computes) action();
    } catch (const solver::GuardStop& stop) {
        stopped = stop.what();
    } catch (const std::exception& error) {
        failure = parallel::text_of(error);
    }
    parallel::meet(comm, failure);
    failure = parallel::first_failure(comm, failure);
    if (!failure.empty()) throw std::runtime_error(failure);
    stopped = comm.broadcast(stopped);
    if (!stopped.empty()) throw solver::GuardStop(stopped);
}

}  // namespace weavefront::app
