#pragma once
/// @file
/// Some ranks compute while the others leave their cores alone.

#include <optional>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// The first `count` ranks; none on the others. @note Collective
std::optional<parallel::Communicator> first_ranks(const parallel::Communicator& comm, int count);

/// Waits for all ranks asleep: MPI's own barrier would take processor time from those that still compute. @note Collective
void sleep_until_all_arrive(const parallel::Communicator& comm);

}  // namespace weavefront::app
