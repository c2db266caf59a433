#pragma once
/// @file
/// The explicit time integration of an impact.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weavefront/contact/sliding_account.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/solver/balance.hpp"
#include "weavefront/solver/joined_fabric.hpp"
#include "weavefront/solver/model.hpp"
#include "weavefront/solver/passages.hpp"
#include "weavefront/solver/phases.hpp"
#include "weavefront/solver/step_bound.hpp"

namespace weavefront::solver {

/// What is counted on the way: from step to step of this rank's elements, not multiplied by symmetry, and
/// from row to row of the whole target.
struct Counts {
    std::int64_t broken_yarns = 0, eroded_elements = 0;
    std::vector<double> first_break;  ///< by ply, s; largest double: none
    std::int64_t searches = 0;        ///< how often what may meet was looked for, the first time included
    std::int64_t inverted = 0;        ///< elements folded over themselves, most of the rows
    double max_displacement = 0, back_face_deflection = 0;  ///< largest of the rows, m
    double lowest_contact_energy = 0;                    ///< J, over the rows: below zero contact gave energy
    double largest_hourglass = 0, largest_internal = 0;  ///< J, over the rows
    double largest_closure_error = 0;                    ///< of the rows, see Balance
    contact::Deepest deepest;                            ///< over the steps, of this rank's elements
    bool touched = false;                                ///< whether any force ever acted on the projectile
    double last_touched = 0;                             ///< when it did last, s
    std::optional<double> turned_back;  ///< when the projectile first moved away from the target, s
};

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
    /// @note Collective, as all functions that are not const, and `balance`
    Simulation(const scene::Scene& scene, const parallel::Communicator& comm);

    /// Elements, contact, halo sum, time step.
    /// @throws GuardStop on all ranks when a force is not finite or out of range
    void advance_forces();

    /// Velocities, positions, contact work, erosion; ghosts when what may meet has to be looked for anew.
    void integrate();

    /// Goes on with other columns on this rank, without changing a bit; between integrate and advance_forces.
    void redistribute(const partition::Decomposition& decomposition);

    /// Asks all ranks to stop; they agree in the next `advance_forces`, without a message of its own. Not
    /// collective.
    void ask_to_stop() { is_stop_asked_ = true; }
    /// Whether a rank has asked to stop.
    [[nodiscard]] bool is_stop_agreed() const { return is_stop_agreed_; }

    /// Energies and motion now; between advance_forces and integrate. @note Collective
    [[nodiscard]] Balance balance();

    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double time_step() const { return dt_; }
    [[nodiscard]] std::int64_t steps() const { return steps_; }
    [[nodiscard]] const Model& model() const { return model_; }
    [[nodiscard]] Model& model() { return model_; }
    [[nodiscard]] const mesh::Panel& panel() const { return panel_; }
    [[nodiscard]] const Counts& counts() const { return counts_; }
    [[nodiscard]] const Passages& passages() const { return passages_; }
    /// The fabric that is still joined to the target now. @note Collective
    [[nodiscard]] const JoinedFabric& joined_fabric();
    /// The deepest penetration of all ranks up to now. @note Collective
    [[nodiscard]] contact::Deepest deepest() const;
    /// Elements that lie behind the next ply although no element of that ply is eroded. @note Collective
    [[nodiscard]] CrossedElements crossed_elements() const;
    /// Whether an edge of the target is held or rests on the frame.
    [[nodiscard]] bool is_supported() const {
        return std::ranges::any_of(scene_.target->edges,
                                   [](scene::Edge edge) { return edge != scene::Edge::free; });
    }
    [[nodiscard]] double projectile_diameter() const {
        return scene_.projectile ? scene_.projectile->diameter : 0;
    }
    [[nodiscard]] PhaseSeconds& seconds() { return seconds_; }
    [[nodiscard]] const PhaseSeconds& seconds() const { return seconds_; }
    /// Whether the host of this rank lacks memory for its ranks to share: they send messages then.
    [[nodiscard]] bool lacks_shared_memory() const { return shared_memory_.is_refused(); }
    /// Position of the projectile's nose at the start, m.
    [[nodiscard]] const Vec3& initial_projectile() const { return initial_projectile_; }
    /// Velocity of an own node at the present time, as of the projectile between advance_forces and
    /// integrate, m/s. The scheme itself keeps those of the middle of the last step.
    [[nodiscard]] Vec3 velocity(std::size_t node) const;
    /// @pre there is a projectile
    [[nodiscard]] Vec3 projectile_velocity() const;

  private:
    enum ContactKind : std::size_t { of_projectile, of_plies, of_frame, contact_kinds };

    void advance_elements();
    void evaluate_contact();
    void sum_over_ranks();
    void adapt_time_step();
    void list_supports();
    void hold_supports();
    void move_nodes();
    void update_candidates();
    void release_debris_nodes();
    void record_events(const shell::Events& events);
    void book_sliding(ContactKind kind);
    void count_contact_work(double dt);  // of half a step
    void add_energy(std::int64_t& sum, double energy);
    [[noreturn]] void stop_at_fault() const;
    [[nodiscard]] bool moved_far() const;
    [[nodiscard]] Vec3 without_mirrored(Vec3 force) const;
    /// Change of a node's velocity without damping. @param step from the middle of the last step to that of
    /// this one, s
    [[nodiscard]] Vec3 velocity_increment(std::size_t node, double step) const {
        return step * (model_.assembly.value(model_.nodes.force[node]) / model_.nodes.mass[node]);
    }
    [[nodiscard]] Vec3 updated_velocity(std::size_t node) const {
        const double step = (last_dt_ + dt_) / 2, drag = scene_.damping * step / 2;
        if (drag == 0) return model_.nodes.v[node] + velocity_increment(node, step);
        return ((1 - drag) * model_.nodes.v[node] + velocity_increment(node, step)) / (1 + drag);
    }
    void look_for_passages();

    struct LedgerSums;
    /// Largest displacements along z over all ranks, m.
    struct Displacements {
        double of_joined = 0, of_back_face = 0, of_debris = 0;
    };
    void add_nodal_energies(LedgerSums& sums) const;
    void add_element_energies(LedgerSums& sums) const;
    [[nodiscard]] Displacements displacements(LedgerSums& sums) const;
    void add_projectile(Balance& balance) const;
    void close(Balance& balance);
    [[nodiscard]] double damping_work(std::size_t node, const Vec3& next, double backward,
                                      double forward) const;

    scene::Scene scene_;
    const parallel::Communicator& comm_;
    parallel::SharedMemoryExchange shared_memory_;
    PhaseSeconds seconds_{};
    mesh::Panel panel_;
    Model model_;
    double multiplicity_;
    StepBound step_bound_;
    std::vector<std::size_t> held_;  // nodes with a support

    double time_ = 0, dt_ = 0, last_dt_ = 0;  // last_dt_: from the last state to this one
    std::int64_t steps_ = 0;
    std::int64_t next_check_ = 0;  // step at which the time step is adapted again
    bool step_check_due_ = false;  // yarns of any rank, so far that this has to be done now

    bool is_stop_asked_ = false, is_stop_agreed_ = false;  // on this rank, on any

    FixedVector on_projectile_{};
    Vec3 projectile_force_{0, 0, 0},
        frame_force_{0, 0, 0};  // on the projectile: of all, and of the frame alone, N
    Vec3 initial_projectile_{0, 0, 0};
    contact::ContactForces contact_;
    std::array<contact::SlidingAccount, contact_kinds> sliding_;
    std::array<std::int64_t, contact_kinds> sliding_released_{},
        sliding_wanted_{};  // in this step on this rank, of energy_
    shell::AlignedVector<double> pack_forces_;

    bool candidates_outdated_ = true;
    bool any_eroded_ = false;                              // whether an element of any rank has been eroded
    contact::SweptBounds swept_nodes_, swept_projectile_;  // until candidates are chosen again
    std::vector<std::int32_t> just_eroded_;

    parallel::FixedPoint energy_, mass_scale_;
    std::int64_t contact_work_ = 0, damping_work_ = 0, eroded_work_ = 0, eroded_friction_ = 0,
                 eroded_hourglass_ = 0;  // of energy_
    double initial_energy_ = 0, energy_scale_ = 0, transferred_energy_ = 0;
    bool faulty_energy_ = false;  // some work was not finite, or too large to be true
    Counts counts_;
    Passages passages_;
    JoinedFabric joined_;
    std::int64_t joined_at_ = 0;  // yarns that were broken on any rank when it was found
};

}  // namespace weavefront::solver
