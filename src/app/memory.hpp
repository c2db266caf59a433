#pragma once
/// @file
/// What a target takes of a machine's memory.

#include <string>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// Bytes that a run takes at the most, on all ranks together. Moving columns (`--rebalance`) takes as much
/// again for a while.
double memory_needed(const mesh::Panel& panel);

/// Bytes that this machine has to give.
double memory_here();

/// In MB, or in GB from 1 GB on.
std::string bytes_text(double bytes);

/// @param models so many are computed side by side by groups of the ranks
/// @throws std::runtime_error on all ranks when the ranks of one machine together need more than it has to
/// give
/// @note Collective
void require_memory(const mesh::Panel& panel, const parallel::Communicator& comm, int models = 1);

}  // namespace weavefront::app
