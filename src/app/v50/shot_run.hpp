#pragma once
/// @file
/// Computes shots on groups of ranks.

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "shot_row.hpp"
#include "v50_plan.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// Computes shots side by side, each through the same code as `run`. A shot whose folder holds a checkpoint
/// goes on from it. What a shot fails of is noted in its row, on all ranks, and other shots go on.
/// @param rows   on all ranks alike
/// @param folder of `v50`
/// @param told   called on one rank of a group when its shot has ended
/// @throws Interrupted on all ranks, when all shots have ended or left checkpoints, where one was asked to
/// stop
/// @note Collective
void compute_shots(const V50Plan& plan, std::span<ShotRow> rows, const std::filesystem::path& folder,
                   const parallel::Communicator& comm, const std::function<void(const ShotRow&)>& told);

}  // namespace weavefront::app
