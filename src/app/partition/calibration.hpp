#pragma once
/// @file
/// The constants of the cost model, measured.

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/partition/machine.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// Refuses what the constants cannot be measured with: one rank, or a scene without contact between plies.
/// @throws scene::InputError
void require_calibration(const scene::Scene& scene, int ranks);

/// Computes the scene to its end on one rank alone, then on every rank at once without communication, and
/// times messages between ranks.
/// @return complete on rank 0
/// @throws scene::InputError when the run is too short to tell contact from the rest; solver::GuardStop
/// @note Collective
partition::Machine calibrate(const scene::Scene& scene, const parallel::Communicator& comm, int repetitions);

}  // namespace weavefront::app
