#pragma once
/// @file
/// Results of one kind of contact in a step.

#include <cstdint>
#include <vector>

#include "weavefront/contact/deepest.hpp"
#include "weavefront/contact/sliding_energy.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Moment on a projectile about its centre of mass.
struct MomentOnProjectile {
    Vec3 moment;  ///< N m
    std::uint16_t projectile;
};

/// Forces of pairs, sliding energy of facets, and the deepest penetration.
struct ContactForces {
    std::vector<PairForce> pairs;             ///< of the pressures
    std::vector<PairForce> friction;          ///< tangential, of pairs with friction
    std::vector<SlidingEnergy> sliding;       ///< J, one for each facet with sliding
    std::vector<MomentOnProjectile> moments;  ///< on those that turn, one for each facet that presses
    std::vector<MomentOnProjectile> friction_moments;  ///< the same of the tangential forces
    Deepest deepest;

    void clear() {
        pairs.clear(), friction.clear(), sliding.clear(), moments.clear(), friction_moments.clear();
        deepest = {};
    }
};

}  // namespace weavefront::contact
