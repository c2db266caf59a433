#pragma once
/// @file
/// Bound on the highest frequency of the whole model, from which the time step follows.

#include <cstdint>
#include <optional>
#include <span>

#include "weavefront/contact/surface.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/solver/contact_modes.hpp"
#include "weavefront/solver/model.hpp"
#include "weavefront/solver/tight_step_bound.hpp"

namespace weavefront::solver {

/// Upper bound on omega^2, the largest eigenvalue of M^-1 K of the whole model. Central differences are
/// stable up to dt = 2/omega. tests/stability/README.md explains the bound with its formulae.
///
/// The plain bound is max(in_plane, out_of_plane) + contact. By the element eigenvalue inequality the largest
/// omega^2 of an element bounds the fabric. Motion in the plane and out of it are independent in an element,
/// so the larger counts. Contact counts as closed everywhere and unloading. Its omega^2 is added, since the
/// largest eigenvalue of a sum is at most the sum of the largest eigenvalues.
///
/// TightStepBound lowers the plain bound where its premises hold.
class StepBound {
  public:
    StepBound(const scene::Scene& scene, const mesh::Panel& panel);

    /// omega^2, 1/s2.
    /// @param pairs in contact at present. Contact that closes before the next call is taken to act along the
    /// normals of plies.
    /// @note Collective
    [[nodiscard]] double frequency_squared(const Model& model, std::span<const contact::PairForce> pairs,
                                           const parallel::Communicator& comm);

    /// In how many steps the bound should be asked for again at the latest. In between it changes by far less
    /// than a safety factor leaves.
    [[nodiscard]] std::int64_t steps_to_next() const;

    /// Has the groups monitor what asks for a new bound before then: ElementGroup::has_stiffened.
    void set_triggers(Model& model) const;

    /// What earlier calls have found: the next bound depends on it.
    template <class Archive>
    void state(Archive& archive) {
        if (tight_) tight_->state(archive);
    }

  private:
    ContactModes contact_;
    std::optional<TightStepBound> tight_;
};

}  // namespace weavefront::solver
