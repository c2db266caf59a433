#pragma once
/// @file
/// What a column costs a step.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// Cost of every column in nanoseconds a step, a mean over the run: its elements, and contact while the zone
/// around the shot holds it. By the committed machine, so that the decomposition is the same on every one.
std::vector<std::int32_t> column_costs(const mesh::Panel& panel, const scene::Scene& scene);

}  // namespace weavefront::partition
