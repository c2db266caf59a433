#pragma once
/// @file
/// What all ranks agree on in every step.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::solver {

/// Kinds of contact, each with an account of its own for the energy of sliding.
enum ContactKind : std::size_t { of_projectile, of_plies, of_frame, contact_kinds };

/// Integers of one rank before the sum, of all ranks after it. Flags count ranks.
struct StepAgreement {
    /// Of the fabric on a projectile.
    struct OnProjectile {
        std::array<std::int64_t, 3> force{};   ///< of the scale of the forces
        std::array<std::int64_t, 3> moment{};  ///< of the scale of the moments
    };

    std::vector<OnProjectile> on_projectiles;
    std::int64_t eroded = 0;          ///< elements in this step
    std::int64_t left_skin = 0;       ///< a node has left its swept bounds
    std::int64_t adaptation_due = 0;  ///< the time step has to be adapted at once
    std::int64_t stop = 0;            ///< the run has to end
    std::int64_t checkpoint = 0;      ///< the state has to be written
    std::int64_t fault = 0;           ///< a force or an energy is not finite, or out of range
    std::array<std::int64_t, contact_kinds> sliding_released{}, sliding_wanted{};  ///< of the ledger's scale

    /// Sets all integers to 0.
    void clear();
    /// Sums all integers over the ranks in one message. @note Collective
    void sum(const parallel::Communicator& comm);

  private:
    template <class Visit>
    void visit(Visit visit);

    std::vector<std::int64_t> message_;
};

}  // namespace weavefront::solver
