#pragma once
/// @file
/// What a column costs a step.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// Cost of every column in nanoseconds a step: its elements, and contact where the shot presses the plies together.
std::vector<std::int32_t> column_costs(const mesh::Panel& panel, const scene::Scene& scene);

}  // namespace weavefront::partition
