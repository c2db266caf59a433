#pragma once
/// @file
/// What contact of one kind does in a step.

#include <vector>

#include "weavefront/contact/deepest.hpp"
#include "weavefront/contact/sliding_energy.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Forces of pairs, the energy that sliding moved in each facet, and the deepest point.
struct ContactForces {
    std::vector<PairForce> pairs;
    std::vector<SlidingEnergy> sliding;  ///< J; facets where nothing slides have none
    Deepest deepest;

    void clear() { pairs.clear(), sliding.clear(), deepest = {}; }
};

}  // namespace weavefront::contact
