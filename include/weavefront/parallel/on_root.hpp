#pragma once
/// @file
/// Actions of rank 0 on behalf of all ranks.

#include <exception>
#include <stdexcept>
#include <string>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/failure.hpp"

namespace weavefront::parallel {

/// Runs `action` on rank 0.
/// @return message of its exception, on all ranks; empty: none
/// @note Collective
template <class Action>
std::string failure_on_root(const Communicator& comm, Action&& action) {
    std::string failure;
    try {
        if (comm.rank() == 0) action();
    } catch (const std::exception& error) {
        failure = text_of(error);
    }
    return comm.broadcast(failure);
}

/// Runs `action` on rank 0. If it fails, no rank is left waiting for its result.
/// @throws std::runtime_error on all ranks if `action` throws on rank 0
/// @note Collective
template <class Action>
void on_root(const Communicator& comm, Action&& action) {
    const auto failure = failure_on_root(comm, action);
    if (!failure.empty()) throw std::runtime_error(failure);
}

}  // namespace weavefront::parallel
