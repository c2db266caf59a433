#pragma once
/// @file
/// Results of one kind of contact in a step.

#include <vector>

#include "weavefront/contact/deepest.hpp"
#include "weavefront/contact/sliding_energy.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Forces of pairs, sliding energy of facets, and the deepest penetration.
struct ContactForces {
    std::vector<PairForce> pairs;        ///< of the pressures
    std::vector<PairForce> friction;     ///< tangential, of pairs with friction
    std::vector<SlidingEnergy> sliding;  ///< J, one for each facet with sliding
    /// Moments on a projectile that turns, N m: about its centre of mass, one for each facet that presses.
    std::vector<Vec3> moments;
    std::vector<Vec3> friction_moments;  ///< the same of the tangential forces
    Deepest deepest;

    void clear() {
        pairs.clear(), friction.clear(), sliding.clear(), moments.clear(), friction_moments.clear();
        deepest = {};
    }
};

}  // namespace weavefront::contact
