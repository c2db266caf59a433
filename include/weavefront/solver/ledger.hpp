#pragma once
/// @file
/// Energies that a rank has counted step by step.

#include <cstdint>

#include "weavefront/parallel/fixed_point.hpp"

namespace weavefront::solver {

/// Sums of one rank, as integers of `scale`: their sums over the ranks do not depend on an order.
struct Ledger {
    parallel::FixedPoint scale, mass_scale;  ///< of energies, of masses
    double initial_energy = 0;               ///< of the projectiles, J
    double energy_scale = 0;                 ///< most that the target can take over, J
    double transferred_energy = 0;           ///< most that was recorded outside of the projectiles, J
    std::int64_t contact = 0, damping = 0;
    std::int64_t contact_friction = 0;
    bool has_contact_friction = false;  ///< of the scene
    std::int64_t eroded_work = 0, eroded_friction = 0, eroded_hourglass = 0;
    bool is_faulty = false;  ///< an energy was not finite, or too large to be true

    /// Adds an energy to one of the sums. @param energy J
    void add(std::int64_t& sum, double energy) {
        if (scale.fits(energy))
            sum += scale.from(energy);
        else
            is_faulty = true;
    }

    template <class Archive>
    void state(Archive& archive) {
        archive("ledger.transferred_energy", transferred_energy);
        archive.sum("ledger.contact", contact);
        if (has_contact_friction) archive.sum("ledger.contact_friction", contact_friction);
        archive.sum("ledger.damping", damping);
        archive.sum("ledger.eroded_work", eroded_work);
        archive.sum("ledger.eroded_friction", eroded_friction);
        archive.sum("ledger.eroded_hourglass", eroded_hourglass);
    }
};

}  // namespace weavefront::solver
