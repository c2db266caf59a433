#pragma once
/// @file
/// Cost of the columns.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// Cost of every column in nanoseconds per step, as a mean over the run: its elements, and contact while the
/// column is in the ContactZone. The constants are those of the committed machine, so the decomposition is
/// the same on every machine.
std::vector<std::int32_t> column_costs(const mesh::Panel& panel, const scene::Scene& scene);

}  // namespace weavefront::partition
