#pragma once
/// @file
/// The explicit time integration of an impact.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weavefront/contact/sliding_account.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/solver/balance.hpp"
#include "weavefront/solver/clock.hpp"
#include "weavefront/solver/counts.hpp"
#include "weavefront/solver/guard.hpp"
#include "weavefront/solver/joined_fabric.hpp"
#include "weavefront/solver/ledger.hpp"
#include "weavefront/solver/model.hpp"
#include "weavefront/solver/phases.hpp"
#include "weavefront/solver/saved_state.hpp"
#include "weavefront/solver/shot.hpp"
#include "weavefront/solver/step_agreement.hpp"
#include "weavefront/solver/step_bound.hpp"

namespace weavefront::solver {

/// Elements that have come through another ply unseen.
struct CrossedElements {
    std::int64_t count = 0, first = 0;  ///< the lowest one
};

/// Distance from a rank's own facets up to which those of others become its ghosts, m; 0: contact needs none
/// of them.
double ghost_reach(const scene::Scene& scene, const mesh::Panel& panel);

/// Central differences: `advance_forces` completes the state at the present time (forces from the positions),
/// `integrate` moves on to the next. Between the two the state may be observed.
class Simulation {
  public:
    /// @note Collective, as all functions that are not const, and `balance`, `joined_fabric`
    Simulation(const scene::Scene& scene, const parallel::Communicator& comm);

    /// Advances elements and contact to the present positions, sums their forces over the ranks, zeroes the
    /// supported forces, adapts the time step and notes passages. Called once per step, since history
    /// variables advance.
    /// @throws GuardStop on all ranks when a force is not finite or out of range
    void advance_forces();

    /// Moves the nodes, books the contact work and removes eroded elements from the contact surface. Searches
    /// for contact candidates and ghosts where a search is due.
    void integrate();

    /// Goes on with other columns on this rank, without changing a bit; between integrate and advance_forces.
    void redistribute(const partition::Decomposition& decomposition);

    /// Asks all ranks to stop, or to write a checkpoint; they agree in the next `advance_forces`, without a
    /// message of its own. Not collective.
    void request_stop() { stop_requested_ = true; }
    void request_checkpoint() { checkpoint_requested_ = true; }
    /// Whether a rank had asked for it before the last `advance_forces`.
    [[nodiscard]] bool is_stop_agreed() const { return agreement_.stop > 0; }
    [[nodiscard]] bool is_checkpoint_agreed() const { return agreement_.checkpoint > 0; }

    /// The state between integrate and advance_forces, from which a run goes on with the same bits on any
    /// number of ranks. @note Collective
    [[nodiscard]] SavedState save();
    /// Goes on from a state of the same scene, between integrate and advance_forces.
    /// @param saved tables of this rank's nodes and owned elements, in the order of the model's global ids
    /// @throws state::Mismatch on all ranks when it is not a state of this scene and this program
    /// @note Collective
    void restore(SavedState saved);

    /// Energies and motion now; between advance_forces and integrate. @note Collective
    [[nodiscard]] Balance balance() const;
    /// The same, and its extremes are counted. @note Collective
    Balance record_balance();

    /// Where and why the guard has stopped, and what to try: a clause to be added to the message of the stop.
    /// It is the same on all ranks and on any number of them. @note Collective
    [[nodiscard]] std::string diagnosis(Fault fault) const;

    [[nodiscard]] double time() const { return clock_.time; }
    /// That of the last step, s.
    [[nodiscard]] double last_time() const { return clock_.time - clock_.last_dt; }
    [[nodiscard]] double time_step() const { return clock_.dt; }
    [[nodiscard]] std::int64_t steps() const { return clock_.steps; }
    [[nodiscard]] const Model& model() const { return model_; }
    [[nodiscard]] Model& model() { return model_; }
    [[nodiscard]] const mesh::Panel& panel() const { return panel_; }
    [[nodiscard]] const Counts& counts() const { return counts_; }
    /// Of each projectile.
    [[nodiscard]] const std::vector<Shot>& shots() const { return shots_; }
    /// As looked for now and then.
    [[nodiscard]] const ProjectileOverlap& projectile_overlap() const { return projectile_overlap_; }
    /// The fabric that is still joined to the target now. @note Collective
    [[nodiscard]] const JoinedFabric& joined_fabric() const;
    /// The deepest penetration of all ranks up to now. @note Collective
    [[nodiscard]] contact::Deepest deepest() const;
    /// Elements that lie behind the next ply although no element of that ply is eroded. @note Collective
    [[nodiscard]] CrossedElements crossed_elements() const;
    /// Whether any contact has friction.
    [[nodiscard]] bool has_contact_friction() const { return ledger_.has_contact_friction; }
    /// Whether an edge of the target is held or rests on the frame.
    [[nodiscard]] bool is_supported() const {
        return std::ranges::any_of(scene_.target->edges,
                                   [](scene::Edge edge) { return edge != scene::Edge::free; });
    }
    [[nodiscard]] double projectile_diameter(std::size_t projectile) const {
        return scene_.projectiles[projectile].diameter;
    }
    [[nodiscard]] PhaseSeconds& seconds() { return seconds_; }
    [[nodiscard]] const PhaseSeconds& seconds() const { return seconds_; }
    /// Whether the host of this rank lacks memory for its ranks to share: they send messages then.
    [[nodiscard]] bool lacks_shared_memory() const { return shared_memory_.is_refused(); }
    /// Velocity of an own node at the present time, as of a projectile between advance_forces and
    /// integrate, m/s. The scheme itself keeps those of the middle of the last step.
    [[nodiscard]] Vec3 velocity(std::size_t node) const;
    [[nodiscard]] Vec3 projectile_velocity(std::size_t projectile) const;
    /// Angular velocity of a projectile at the present time, rad/s.
    [[nodiscard]] Vec3 projectile_angular_velocity(std::size_t projectile) const;

  private:
    void advance_elements();
    void evaluate_contact();
    void add_clamp_forces();
    void sum_forces_and_agree();
    void apply_agreement();
    void follow_model();
    void adapt_time_step();
    void list_supports();
    void hold_supports();
    void move_nodes();
    void update_candidates();
    void release_debris_nodes();
    void record_events(const shell::Events& events);
    void book_sliding(ContactKind kind);
    void add_half_step_contact_work(double dt);
    /// @param moments on projectiles that turn
    void add_contact_work(std::int64_t& taken, std::span<const contact::PairForce> pairs,
                          std::span<const contact::MomentOnProjectile> moments, double dt);
    /// @param from_frame on the projectile
    void add_frame_work(std::int64_t& taken, const body::RigidBody& projectile,
                        const body::Wrench& from_frame, double dt);
    [[noreturn]] void stop_at_fault() const;
    /// Global id of the lowest element with a force that is not finite or out of range; -1: none.
    /// @note Collective
    [[nodiscard]] std::int64_t faulty_element() const;
    [[nodiscard]] std::int64_t worst_element(Fault fault) const;
    [[nodiscard]] double severity(Fault fault, std::size_t element) const;
    [[nodiscard]] bool moved_far() const;
    [[nodiscard]] body::Wrench without_mirrored(body::Wrench wrench) const;
    /// Points about which facets under the projectiles are searched, m; until the next call.
    [[nodiscard]] std::span<const Vec3> search_points() const;
    /// Velocity of a local node in the middle of this step, damping included, m/s.
    [[nodiscard]] Vec3 updated_velocity(std::size_t node) const;
    void look_for_passages();

    struct LedgerSums;
    /// Largest displacements along z over all ranks, m.
    struct Displacements {
        double of_joined = 0, of_back_face = 0, of_debris = 0;
    };
    void add_nodal_energies(LedgerSums& sums) const;
    void add_element_energies(LedgerSums& sums) const;
    [[nodiscard]] Displacements displacements(LedgerSums& sums) const;
    void add_projectiles(Balance& balance) const;
    void close(Balance& balance) const;
    template <class Archive>
    void visit_values(Archive& archive);
    void read_state(SavedState& saved);
    [[nodiscard]] double damping_work(std::size_t node, const Vec3& next, double backward,
                                      double forward) const;

    scene::Scene scene_;
    const parallel::Communicator& comm_;
    parallel::SharedMemoryExchange shared_memory_;
    mutable PhaseSeconds seconds_{};
    mesh::Panel panel_;
    Model model_;
    double multiplicity_;
    StepBound step_bound_;
    std::vector<std::size_t> held_;  // nodes with a support

    Clock clock_;
    std::int64_t next_adaptation_ = 0;  // step at which the time step is adapted again
    bool stop_requested_ = false, checkpoint_requested_ = false;  // by this rank
    StepAgreement agreement_;  // of this rank while forces are computed, then of all ranks

    contact::ContactForces contact_;
    std::array<contact::SlidingAccount, contact_kinds> sliding_;
    shell::AlignedVector<double> pack_forces_;

    struct Search {
        bool is_outdated = true;
        bool any_eroded = false;                  // elements of any rank
        contact::SweptBounds nodes, projectiles;  // until candidates are chosen again
    };
    Search search_;
    mutable std::vector<Vec3> search_points_;
    std::vector<std::int32_t> just_eroded_;

    Ledger ledger_;
    Counts counts_;
    std::vector<Shot> shots_;
    ProjectileOverlap projectile_overlap_;
    mutable JoinedFabric joined_;         // found anew when it is asked for and yarns have broken since
    mutable std::int64_t joined_at_ = 0;  // yarns that were broken on any rank when it was found
};

}  // namespace weavefront::solver
