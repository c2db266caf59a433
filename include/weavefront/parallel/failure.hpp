#pragma once
/// @file
/// Failures of one rank that must not leave other ranks waiting.

#include <exception>
#include <string>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::parallel {

/// Message of an exception. Where the message of a library says too little, the text is ours.
std::string text_of(const std::exception& error);

/// Prints the message with the number of this rank.
void tell_failure(const std::string& message);

/// Ends all ranks with exit status 3.
[[noreturn]] void end_all_ranks();

/// Waits, asleep, until all ranks have called it. A rank with a failure waits for some seconds only. After
/// that the other ranks are assumed to wait elsewhere: the failure is printed and all ranks end with exit
/// status 3.
/// @param failure of this rank; empty: none
/// @note Collective
void meet(const Communicator& comm, const std::string& failure = {});

/// The failure of the lowest rank that has one, returned on all ranks; empty: no rank has one. A rank with a
/// failure waits for ten seconds only. After that, as in `meet`, the failure is printed and all ranks end.
/// @note Collective
[[nodiscard]] std::string first_failure(const Communicator& comm, const std::string& failure);

}  // namespace weavefront::parallel
