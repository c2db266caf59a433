#pragma once
/// @file
/// What a target takes of a machine's memory.

#include <cstdint>
#include <string>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// Bytes that a run takes at the most, on all ranks together: 600 an element, as measured on the large panel of examples/large_panel, whose
/// set-up takes the most. Moving columns (`--rebalance`) takes as much again for a while.
double memory_needed(std::int64_t elements);

/// Bytes that this machine has.
double memory_here();

/// In MB, or in GB from 1 GB on.
std::string bytes_text(double bytes);

/// @throws std::runtime_error on all ranks when the share of one of them alone is more than its machine has
/// @note Collective
void require_memory(std::int64_t elements, const parallel::Communicator& comm);

}  // namespace weavefront::app
