#pragma once
/// @file
/// How long the steps of an impact take.

#include <cstdint>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/solver/phases.hpp"

namespace weavefront::app {

/// One step, the quickest of its repetitions.
struct StepTime {
    double time = 0;     ///< at which it starts, s
    double seconds = 0;  ///< it took
    solver::PhaseSeconds phases{};
    bool searched = false;  ///< what may meet was looked for anew

    [[nodiscard]] double contact() const { return phases[static_cast<std::size_t>(solver::Phase::contact)]; }
};

struct StepTimes {
    std::int64_t elements = 0, nodes = 0;  ///< of this rank
    std::vector<StepTime> steps{};

    [[nodiscard]] double mean() const;  ///< of a step, s
    [[nodiscard]] double sum(solver::Phase phase) const;

    /// Takes the steps of another run that were quicker.
    void improve_by(const StepTimes& other);
};

/// Computes an impact without its output. One rank alone, which never waits, is timed by the processor time
/// that it gets, several by the clock on the wall.
/// @param comm ranks that compute it
/// @throws solver::GuardStop
/// @note Collective
StepTimes time_steps(const scene::Scene& scene, const parallel::Communicator& comm);

}  // namespace weavefront::app
