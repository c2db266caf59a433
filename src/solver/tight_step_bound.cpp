#include "weavefront/solver/tight_step_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "weavefront/fabric/constants.hpp"

namespace weavefront::solver {

namespace {

// A build may leave a part out, to count the steps that the part saves: tests/stability/parts.py.
enum class Part { nothing, flat_contact, free_crossovers, coupling };
constexpr bool has(Part part) { return part != Part::WEAVEFRONT_BOUND_WITHOUT; }

// Square of the sine of the angle between contact and a normal: contact in any direction.
constexpr double any_angle = 1;

// A tight bound must be below this fraction of omega^2, or it is of no use.
constexpr double worth_tightening = 0.85;

// No tight bound is below this fraction of the in-plane omega^2 with crossovers held. It is that of strongly
// crimped yarns whose fill and warp are decoupled.
constexpr double least_in_plane = 0.4;

// The elements' normals are examined where perfectly flat fabric would lower omega^2 by more than this
// factor: the examination costs a thirtieth of the elements' time.
constexpr double worth_looking = 1.05;

// A bound falls by no more than this from one attempt to the next: most elements are then only compared with
// it.
constexpr double follows_down = 0.98;

// In one attempt of so many the neighbours of the best coupling are tried, too.
constexpr int looks_beside = 8;

// At most so many attempts in a row are skipped.
constexpr int most_skips = 32;

// Slack yarns may straighten until their omega^2 is so much above the bound before a new one is sought. The
// step is then half of this excess too long, far less than the safety factor leaves.
constexpr double let_straighten = 1.03;

/// The largest 4 c over the areal density of all fabrics, with the c of the fabric at rest, m2/s2.
double coupling_over_density(const scene::Scene& scene) {
    double largest = 0;
    for (const auto& fabric : scene.fabrics)
        largest = std::max(largest,
                           4 * fabric::coupling_at_rest(fabric::constants_of(fabric)) / fabric.areal_density);
    return largest;
}

struct Yarns {
    bool crimped = false, packing = false;  ///< of any ply
};

/// Yarns whose tangent is known: none where a ply is of the paper's formulation, whose stresses derive from
/// no energy, or of unequal yarns, whose tangent `fabric::tangent_bound` does not have.
Yarns yarns_of(const scene::Scene& scene) {
    Yarns yarns;
    for (const auto& ply : scene.target->plies) {
        const auto& fabric = scene.fabrics[static_cast<std::size_t>(ply.fabric)];
        if (fabric.formulation == scene::Formulation::paper || fabric.warp) return {};
        yarns.crimped = yarns.crimped || fabric.thickness > 0;
        yarns.packing = yarns.packing || fabric.lateral.has_value();
    }
    return yarns;
}

bool any_packed(const Model& model) {
    return std::ranges::any_of(model.groups, [](const auto& group) { return group->any_packed(); });
}

}  // namespace

bool TightStepBound::applies_to(const scene::Scene& scene) {
    const auto yarns = yarns_of(scene);
    return yarns.crimped || yarns.packing || contact_modes(scene).stiffness > 0;
}

TightStepBound::TightStepBound(const scene::Scene& scene, const mesh::Panel& panel)
    : contact_(contact_modes(scene)),
      flat_contact_(panel),
      crimped_(yarns_of(scene).crimped),
      packing_(yarns_of(scene).packing),
      coupling_over_density_(coupling_over_density(scene)),
      smallest_area_(smallest_area(panel)),
      free_edges_(free_edges(panel)) {}

double TightStepBound::frequency_squared(const Model& model, const shell::Frequencies<double>& held,
                                         std::span<const contact::PairForce> pairs,
                                         const parallel::Communicator& comm) {
    const Present present = present_state(model, held, pairs, comm);
    const double bound = joint(present, held.in_plane, present.sine_squared);
    trigger_.reset();
    const double worth = worth_tightening * bound;
    const bool may_pay = has(Part::free_crossovers) &&
                         joint(present, least_in_plane * held.in_plane, present.sine_squared) < worth &&
                         (crimped_ || (packing_ && comm.max(any_packed(model) ? 1.0 : 0.0) > 0));
    if (!may_pay || skips_attempt()) return bound;
    return std::min(bound, attempt(model, present, start_of(present, worth), comm));
}

TightStepBound::Present TightStepBound::present_state(const Model& model,
                                                      const shell::Frequencies<double>& held,
                                                      std::span<const contact::PairForce> pairs,
                                                      const parallel::Communicator& comm) {
    Present present{held, Vec3::UnitZ(), any_angle};
    const double of_flat_fabric = joint(present, held.in_plane, 0);
    const bool flat_pays = has(Part::flat_contact) && contact_.stiffness > 0 &&
                           joint(present, held.in_plane, any_angle) > worth_looking * of_flat_fabric;
    if (flat_pays || crimped_) present.axis = flat_contact_.axis(model, comm);
    if (flat_pays) present.sine_squared = flat_contact_.sine_squared(model, present.axis, pairs, comm);
    return present;
}

/// The bound on the whole model for one on motion in the plane.
double TightStepBound::joint(const Present& present, double in_plane, double sine_squared) const {
    return damped_frequency_squared(in_plane, present.held.out_of_plane, contact_, sine_squared);
}

/// Where the search for each coupling starts, from the last attempt, and the limits that make it worth while.
shell::TighteningStart TightStepBound::start_of(const Present& present, double worth) const {
    const double contact = contact_.stiffness + std::sqrt(worth) * contact_.damping;
    const auto limit = [&](double sine_squared) {
        return in_plane_of_joint(worth - contact_.tangential, present.held.out_of_plane, contact,
                                 sine_squared);
    };
    const bool coupled = has(Part::coupling) && crimped_ &&
                         joint(present, least_in_plane * present.held.in_plane, any_angle) < worth;
    shell::TighteningStart start{{}, {}, present.held.out_of_plane, present.held.hourglass, present.axis};
    start.limits.fill(coupled ? limit(any_angle) : 0);
    start.limits[0] = limit(present.sine_squared);
    const bool starts_anew = best_ < 0 || (best_ > 0 && !coupled);
    for (std::size_t i = 0; i < start.least.size(); ++i) {
        const int apart = std::abs(static_cast<int>(i) - best_);
        const bool is_due = starts_anew || apart == 0 || (attempts_ % looks_beside == 0 && apart == 1);
        const double limit_here = start.limits[i], known = best_ < 0 ? 0 : follows_down * last_[i];
        start.least[i] = is_due ? std::clamp(known, limit_here * 0x1p-20, limit_here) : limit_here;
    }
    return start;
}

/// Whether this attempt is skipped: each attempt in vain doubles the number of skips, up to `most_skips`.
bool TightStepBound::skips_attempt() { return --skips_left_ >= 0; }

/// The least bound on the whole model of all couplings; infinite where none reaches its limit. It sets the
/// trigger.
///
/// Without coupling, an element moves in its plane or out of it, and contact stands within the known angle of
/// its normal. So the joint eigenvalue of the three is a bound. A coupling mixes motion in the plane of an
/// inclined element with motion out of it, and the joint eigenvalue does not hold. But the largest eigenvalue
/// of a sum of matrices is at most the sum of their largest eigenvalues. So the bound of the coupled fabric
/// plus contact in any direction is a bound, too. Both bound the same omega^2, and so does the lesser.
double TightStepBound::attempt(const Model& model, const Present& present,
                               const shell::TighteningStart& start, const parallel::Communicator& comm) {
    shell::TightBounds bounds = start.least;
    for (const auto& group : model.groups) shell::TightBound(*group).raise(start, model.nodes.x, bounds);
    comm.max(bounds);
    double least = std::numeric_limits<double>::infinity();
    best_ = -1;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        last_[i] = bounds[i] < start.limits[i] ? bounds[i] : 0;
        const double factor = shell::couplings[i];
        if (factor > 0 && free_edges_.too_near) continue;
        const double in_plane = with_free_edges(bounds[i], factor, start);
        if (!(in_plane < start.limits[i])) continue;
        const double whole = joint(present, in_plane, factor > 0 ? any_angle : present.sine_squared);
        if (!(whole < least)) continue;
        least = whole;
        best_ = static_cast<int>(i);
    }
    ++attempts_;
    // Attempts in vain become rare: a yarn that has straightened stays straight for long.
    next_skips_ = best_ >= 0 ? 1 : std::min(2 * next_skips_, most_skips);
    skips_left_ = best_ >= 0 ? 0 : next_skips_;
    if (best_ >= 0) {
        const auto best = static_cast<std::size_t>(best_);
        trigger_ = trigger_of(model, shell::couplings[best], bounds[best], comm);
    }
    return least;
}

/// A bound on a ply from one on its elements. @param factor one of `couplings`
double TightStepBound::with_free_edges(double bound, double factor,
                                       const shell::TighteningStart& start) const {
    if (!(factor > 0)) return bound;
    const double coupling = factor * coupling_over_density_;  // m2/s2
    // The other modes of an element reach at most these two bounds. So the excess counts from them.
    const double inside = bound - std::max(start.hourglass, start.out_of_plane);
    const double at_edges = std::max(excess_on_edge(inside, coupling / free_edges_.edge),
                                     excess_at_corner(inside, coupling / free_edges_.corner));
    return std::max(bound + at_edges,
                    coupling / smallest_area_);  // of an eroded element, which keeps the term
}

shell::StiffeningTrigger TightStepBound::trigger_of(const Model& model, double coupling_factor, double bound,
                                                    const parallel::Communicator& comm) const {
    std::array<double, 2> most{bound, any_packed(model) ? 1.0 : 0.0};
    for (const auto& group : model.groups)
        most[0] = std::max(most[0], shell::TightBound(*group).slack_frequency(coupling_factor));
    comm.max(most);
    return {.slack_frequency = let_straighten * most[0],
            .coupling_factor = coupling_factor,
            .awaits_first_packing = most[1] == 0};
}

void TightStepBound::set_triggers(Model& model) const {
    for (const auto& group : model.groups) shell::monitor_stiffening(*group, trigger_);
}

}  // namespace weavefront::solver
