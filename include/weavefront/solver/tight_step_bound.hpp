#pragma once
/// @file
/// A tighter bound on the highest frequency of the whole model, for structured panels.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "weavefront/contact/surface.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/shell/tight_bound.hpp"
#include "weavefront/solver/contact_modes.hpp"
#include "weavefront/solver/coupling_on_edges.hpp"
#include "weavefront/solver/flat_contact.hpp"
#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// Lowers the plain bound of StepBound by three parts.
///
/// - Flat contact: contact acts across the elements' planes, so its stiffness and the fabric's do not add up.
/// - Free crossovers: fabric whose crossovers may move is softer than fabric with crossovers held.
/// - Coupling: elements exchange a term that cancels in the sum over a ply, shell::couplings.
///
/// The second and third part cost as much as some steps. So an attempt must promise enough, and attempts in
/// vain make the next ones rare. tests/stability/README.md tells what each part saves.
class TightStepBound {
  public:
    /// Whether any part may lower the bound of a scene. Flat contact needs contact. The other parts need
    /// crimped or packed yarns, and the consistent formulation with equal fill and warp in all plies.
    [[nodiscard]] static bool applies_to(const scene::Scene& scene);

    TightStepBound(const scene::Scene& scene, const mesh::Panel& panel);

    /// omega^2, 1/s2.
    /// @param held  largest frequencies of all elements with crossovers held, 1/s2
    /// @param pairs in contact at present
    /// @note Collective
    [[nodiscard]] double frequency_squared(const Model& model, const shell::Frequencies<double>& held,
                                           std::span<const contact::PairForce> pairs,
                                           const parallel::Communicator& comm);

    /// Whether the elements are monitored for all that may make the last bound too low. It then holds for
    /// longer.
    [[nodiscard]] bool is_monitored() const { return trigger_ && trigger_->awaits_first_packing; }

    /// Has the groups monitor what makes the last bound too low.
    void set_triggers(Model& model) const;

    /// What earlier calls have found: the next bound depends on it.
    template <class Archive>
    void state(Archive& archive) {
        archive("step_bound.last", std::span(last_));
        archive("step_bound.best", best_);
        archive("step_bound.attempts", attempts_);
        archive("step_bound.waits", skips_left_);
        archive("step_bound.will_wait", next_skips_);
        bool is_set = trigger_.has_value();
        auto trigger = trigger_.value_or(shell::StiffeningTrigger{});
        archive("step_bound.trigger.is_set", is_set);
        archive("step_bound.trigger.slack_frequency", trigger.slack_frequency);
        archive("step_bound.trigger.coupling", trigger.coupling_factor);
        archive("step_bound.trigger.packing", trigger.awaits_first_packing);
        if constexpr (Archive::reads) trigger_ = is_set ? std::optional(trigger) : std::nullopt;
    }

  private:
    bool skips_attempt();
    /// What all parts of one bound refer to.
    struct Present {
        shell::Frequencies<double> held;  ///< of the elements with crossovers held, 1/s2
        Vec3 axis;                        ///< normal of the first ply
        double sine_squared;  ///< of the largest angle between contact and a normal; 1 where unknown
    };

    [[nodiscard]] Present present_state(const Model& model, const shell::Frequencies<double>& held,
                                        std::span<const contact::PairForce> pairs,
                                        const parallel::Communicator& comm);
    [[nodiscard]] double joint(const Present& present, double in_plane, double sine_squared) const;
    [[nodiscard]] shell::TighteningStart start_of(const Present& present, double worth) const;
    [[nodiscard]] double attempt(const Model& model, const Present& present,
                                 const shell::TighteningStart& start, const parallel::Communicator& comm);
    [[nodiscard]] double with_free_edges(double bound, double factor,
                                         const shell::TighteningStart& start) const;
    [[nodiscard]] shell::StiffeningTrigger trigger_of(const Model& model, double coupling_factor,
                                                      double bound, const parallel::Communicator& comm) const;

    ContactModes contact_;
    FlatContact flat_contact_;
    bool crimped_, packing_;  // of any ply, where all are of the consistent formulation and of equal yarns
    double coupling_over_density_;  // 4 c over the areal density, m2/s2
    double smallest_area_;          // m2
    FreeEdges free_edges_;
    std::optional<shell::StiffeningTrigger> trigger_;

    // What the last attempts found: the bounds, 0 where none was sought; which coupling was best, none: -1;
    // the number of attempts; and how many times none is made, now and after the next one in vain.
    shell::TightBounds last_{};
    int best_ = -1, attempts_ = 0, skips_left_ = 0, next_skips_ = 1;
};

}  // namespace weavefront::solver
