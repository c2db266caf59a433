#pragma once
/// @file
/// Times of steps beside the speed that the processor had just then.

#include <limits>

#include "step_times.hpp"

namespace weavefront::app {

/// Steps of an impact that was computed several times over, and the time of a reference step in between.
struct RepeatedSteps {
    StepTimes times;
    double reference_time = std::numeric_limits<double>::max();  ///< least time of an element-step of a small
                                                                 ///< scene, first rank alone, s
};

/// Each step does the same in every repetition, so the quickest of each step is the one least disturbed by
/// whatever else the machine does.
/// @param comm ranks that compute it together
/// @param all  ranks that compute it at the same time: before each repetition all but their first leave their
/// cores alone
/// @throws solver::GuardStop
/// @note Collective
RepeatedSteps repeat_steps(const scene::Scene& scene, const parallel::Communicator& comm,
                           const parallel::Communicator& all, int repetitions);

}  // namespace weavefront::app
