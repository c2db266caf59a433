#pragma once
/// @file
/// The time step before anything has moved, and what sets it.

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::solver {

/// What the highest frequency of the model belongs to.
enum class StepLimit { elements, plies, projectile, frame };

/// The first time step of a run and what it would be without some of the model, all with the scene's safety
/// factor, s.
struct StepLimits {
    double time_step = 0;
    double of_elements = 0;  ///< without any contact
    StepLimit limit = StepLimit::elements;
};

/// The step of StepBound for the undeformed target. Contact limits it where the elements alone allow more
/// than a hundredth more; of the contacts, the one without which the step would be the largest. Needs no MPI.
/// @param panel of the scene's target
[[nodiscard]] StepLimits step_limits(const scene::Scene& scene, const mesh::Panel& panel);

}  // namespace weavefront::solver
