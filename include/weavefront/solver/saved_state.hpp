#pragma once
/// @file
/// The state of a run, apart from how it is spread over ranks.

#include "weavefront/state/table.hpp"
#include "weavefront/state/values.hpp"

namespace weavefront::solver {

/// Named state of a simulation: of the whole run, the same on all ranks; of some nodes and elements.
struct SavedState {
    state::Values values;
    state::Table nodes, elements;
};

}  // namespace weavefront::solver
