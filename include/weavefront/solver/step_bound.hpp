#pragma once
/// @file
/// Bound on the highest frequency of the whole model, from which the time step follows.

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "weavefront/contact/surface.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// What contact adds over the mass that it moves: omega^2 of its springs, 1/s2, and the rate 2 xi omega of
/// its dampers, 1/s.
struct ContactModes {
    double stiffness = 0, damping = 0;
};

/// Contact closed everywhere and unloading, on the slope of u k. The highest mode of a free stack of n plies
/// has f = 4 cos^2(pi/(2 n)) springs over its mass per area, omega^2 = f u k/m and 2 xi omega = f c/m; a
/// light projectile adds its own, with its cross-section for the area.
[[nodiscard]] ContactModes contact_modes(const scene::Scene& scene);

/// Bound on omega^2 of fabric and contact together, 1/s2, without dampers.
///
/// The fabric resists motion in its elements' planes, contact motion along its direction. Where that is the
/// normal of the elements, the larger counts; in between the eigenvalue of the two by two matrix of motion in
/// the plane and out of it.
/// @param in_plane, out_of_plane of the fabric, with respect to its elements, 1/s2
/// @param contact       of contact, 1/s2
/// @param sine_squared  of the largest angle between a normal of an element and a direction of contact
[[nodiscard]] double joint_frequency_squared(double in_plane, double out_of_plane, double contact,
                                             double sine_squared);

/// The same bound with the dampers: central differences whose dampers see the velocity half a step before are
/// stable up to dt = 2/omega with omega^2 = omega_0^2 + omega 2 xi omega_0, so contact counts as stiffness +
/// omega damping.
[[nodiscard]] double damped_frequency_squared(double in_plane, double out_of_plane,
                                              const ContactModes& contact, double sine_squared);

/// The part `in_plane` of a given bound, 1/s2: the inverse of joint_frequency_squared, which has no dampers;
/// 0: none.
[[nodiscard]] double in_plane_of_joint(double joint, double out_of_plane, double contact,
                                       double sine_squared);

/// By how much the omega^2 of a ply with free edges may be above that of an element inside it when the area's
/// second variation is added to all of them, 1/s2: what is left on the edges is c u_i x u_j of neighbouring
/// nodes.
/// @param inside of an element inside, less its hourglass modes, 1/s2
/// @param coupling   4 c over the mass of an element on the edge, 1/s2
[[nodiscard]] double excess_on_edge(double inside, double coupling);
/// The same at a corner between two free edges.
[[nodiscard]] double excess_at_corner(double inside, double coupling);

/// The bound, by the scene's contact and the present state of the elements.
class StepBound {
  public:
    StepBound(const scene::Scene& scene, const mesh::Panel& panel);

    /// omega^2, 1/s2.
    /// @param pairs in contact at present: what else may close until it is asked for again is taken to act
    /// along the normals of plies
    /// @note Collective
    [[nodiscard]] double frequency_squared(const Model& model, std::span<const contact::PairForce> pairs,
                                           const parallel::Communicator& comm);

    /// In how many steps it should be asked for again at the latest. In between it changes by far less than a
    /// safety factor leaves.
    [[nodiscard]] std::int64_t steps_to_next() const { return steps_to_next_; }

    /// Tells the groups what asks for the bound before then.
    void set_triggers(Model& model) const;

    /// What earlier calls have found: the next bound depends on it.
    template <class Archive>
    void state(Archive& archive) {
        archive("step_bound.last", std::span(last_));
        archive("step_bound.best", best_);
        archive("step_bound.attempts", attempts_);
        archive("step_bound.waits", waits_);
        archive("step_bound.will_wait", will_wait_);
        archive("step_bound.steps_to_next", steps_to_next_);
        archive("step_bound.trigger.slack", trigger_.slack);
        archive("step_bound.trigger.coupling", trigger_.coupling);
        archive("step_bound.trigger.packing", trigger_.packing);
    }

  private:
    /// Of the elements in whose place a coupling leaves something on a free edge.
    struct FreeEdges {
        double edge = std::numeric_limits<double>::infinity(), corner = edge;  ///< least areas, m2
        bool too_near = false;  ///< an element has two free edges opposite each other
    };

    static FreeEdges free_edges(const mesh::Panel& panel);
    [[nodiscard]] Vec3 axis_of(const Model& model, const parallel::Communicator& comm) const;
    static double sine_squared_to_contact(const Model& model, const Vec3& axis,
                                          std::span<const contact::PairForce> pairs,
                                          const parallel::Communicator& comm);
    double tightened(const Model& model, const shell::TighteningStart& start, double held,
                     const parallel::Communicator& comm);
    void choose_couplings(bool others_than_none, shell::TighteningStart& start) const;

    std::array<std::int64_t, 3> corners_;  // of the first ply: global nodes, counter-clockwise
    std::array<bool, 2> symmetry_;
    ContactModes contact_;
    double coupling_at_rest_;  // 4 c over the areal density, m2/s2
    double smallest_area_;     // m2
    FreeEdges free_edges_;
    std::int64_t steps_to_next_ = 0;
    shell::ElementGroup::StiffeningTrigger trigger_;

    // What the last attempts to tighten found: the bounds, 0 where none was sought; which coupling was best,
    // none: -1; their number; and how many times none is made, now and after the next one in vain.
    std::array<double, shell::couplings.size()> last_{};
    int best_ = -1, attempts_ = 0, waits_ = 0, will_wait_ = 1;
};

}  // namespace weavefront::solver
