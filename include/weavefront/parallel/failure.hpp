#pragma once
/// @file
/// Failures of one rank, which must not leave the others waiting.

#include <exception>
#include <string>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::parallel {

/// What to tell of an exception: in our words where those of a library do not say what happened.
std::string text_of(const std::exception& error);

/// Prints the message with the number of this rank.
void tell_failure(const std::string& message);

/// Ends all ranks with exit status 3.
[[noreturn]] void end_all_ranks();

/// Waits asleep until all ranks are here. A rank that comes with a failure waits for some seconds only: the
/// others are then taken to wait for it elsewhere; the failure is told and all ranks end with status 3.
/// @param failure of this rank; empty: none
/// @note Collective
void meet(const Communicator& comm, const std::string& failure = {});

/// The failure of the lowest rank that has one, on all ranks; empty: none has. @note Collective
[[nodiscard]] std::string first_failure(const Communicator& comm, const std::string& failure);

}  // namespace weavefront::parallel
