#pragma once
/// @file
/// Where contact went deep or was missed.

#include "weavefront/contact/deepest.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/model.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver {

/// The deepest penetration of all ranks. @note Collective
contact::Deepest deepest_of_all(const contact::Deepest& local, const parallel::Communicator& comm);

/// Elements of all ranks that lie behind the next ply although no element of that ply is eroded. @note
/// Collective
CrossedElements elements_behind_whole_plies(const Model& model, const parallel::Communicator& comm);

}  // namespace weavefront::solver
