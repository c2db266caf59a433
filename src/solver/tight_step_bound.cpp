#include "weavefront/solver/tight_step_bound.hpp"

#include <algorithm>
#include <cmath>

#include "weavefront/fabric/constants.hpp"

namespace weavefront::solver {

namespace {

// An attempt must win this part of omega^2 at least. It comes down to the second part of the fabric's own
// omega^2 at best, that of much crimped yarns with fill and warp apart.
constexpr double worth_tightening = 0.85, least_in_plane = 0.4;

// The elements' normals are looked at where perfectly flat fabric would lower omega^2 by more than this
// factor: the look costs a thirtieth of the elements' time.
constexpr double worth_looking = 1.05;

// A bound falls by no more than this from one time to the next: most elements are then only compared with it.
constexpr double follows_down = 0.98;

// In one attempt of so many the neighbours of the best coupling are tried, too.
constexpr int looks_beside = 8;

// As many times at most no attempt is made, after others in vain.
constexpr int longest_wait = 32;

// Slack yarns may straighten until their omega^2 is so much above the bound before a new one is sought: half
// of it is the step's, far less than the safety factor leaves.
constexpr double let_straighten = 1.03;

double coupling_at_rest(const scene::Scene& scene) {
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
/// no energy.
Yarns yarns_of(const scene::Scene& scene) {
    Yarns yarns;
    for (const auto& ply : scene.target->plies) {
        const auto& fabric = scene.fabrics[static_cast<std::size_t>(ply.fabric)];
        if (fabric.formulation == scene::Formulation::paper) return {};
        yarns.crimped = yarns.crimped || fabric.thickness > 0;
        yarns.packing = yarns.packing || fabric.lateral.has_value();
    }
    return yarns;
}

bool any_packed(const Model& model) {
    return std::ranges::any_of(model.groups, [](const auto& group) { return group->any_packed(); });
}

}  // namespace

bool TightStepBound::may_hold(const scene::Scene& scene) {
    const auto yarns = yarns_of(scene);
    return yarns.crimped || yarns.packing || contact_modes(scene).stiffness > 0;
}

TightStepBound::TightStepBound(const scene::Scene& scene, const mesh::Panel& panel)
    : contact_(contact_modes(scene)),
      flat_contact_(panel),
      crimped_(yarns_of(scene).crimped),
      packing_(yarns_of(scene).packing),
      coupling_at_rest_(coupling_at_rest(scene)),
      smallest_area_(smallest_area(panel)),
      free_edges_(free_edges(panel)) {}

double TightStepBound::frequency_squared(const Model& model, const shell::Frequencies<double>& held,
                                         std::span<const contact::PairForce> pairs,
                                         const parallel::Communicator& comm) {
    const auto joint = [&](double in_plane, double sine_squared) {
        return damped_frequency_squared(in_plane, held.out_of_plane, contact_, sine_squared);
    };
    const bool flat_pays =
        contact_.stiffness > 0 && joint(held.in_plane, 1) > worth_looking * joint(held.in_plane, 0);
    const Vec3 axis = flat_pays || crimped_ ? flat_contact_.axis(model, comm) : Vec3::UnitZ();
    const double sine_squared = flat_pays ? flat_contact_.sine_squared(model, axis, pairs, comm) : 1;
    const double worth = worth_tightening * joint(held.in_plane, sine_squared);
    double in_plane = held.in_plane;
    trigger_.reset();
    const bool may_pay = joint(least_in_plane * held.in_plane, sine_squared) < worth &&
                         (crimped_ || (packing_ && comm.max(any_packed(model) ? 1.0 : 0.0) > 0));
    if (may_pay && --waits_ < 0) {
        const double contact = contact_.stiffness + std::sqrt(worth) * contact_.damping;
        const double limit = in_plane_of_joint(worth, held.out_of_plane, contact, sine_squared);
        // The coupling of an element that leans over mixes motion in its plane and out of it: only where
        // contact does not need them apart.
        const bool coupled = sine_squared == 1 && crimped_;
        in_plane =
            tightened(model, {first_bounds(coupled, limit), limit, held.out_of_plane, held.hourglass, axis},
                      in_plane, comm);
    }
    return joint(in_plane, sine_squared);
}

/// Where the search for each coupling starts: from the last attempt, or at the limit where it is not tried.
shell::TightBounds TightStepBound::first_bounds(bool coupled, double limit) const {
    const auto may_help = [&](double coupling) { return coupling == 0 || coupled; };
    const bool starts_anew = best_ < 0 || !may_help(shell::couplings[static_cast<std::size_t>(best_)]);
    shell::TightBounds bounds{};
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const int apart = std::abs(static_cast<int>(i) - best_);
        const bool is_due = starts_anew || apart == 0 || (attempts_ % looks_beside == 0 && apart == 1);
        const double known = best_ < 0 ? 0 : follows_down * last_[i];
        bounds[i] =
            is_due && may_help(shell::couplings[i]) ? std::clamp(known, limit * 0x1p-20, limit) : limit;
    }
    return bounds;
}

/// The least bound of all couplings, at most `held`; sets the trigger where it is less.
double TightStepBound::tightened(const Model& model, const shell::TighteningStart& start, double held,
                                 const parallel::Communicator& comm) {
    shell::TightBounds bounds = start.least;
    for (const auto& group : model.groups) shell::TightBound(*group).raise(start, model.nodes.x, bounds);
    comm.max(bounds);
    double least = held;
    best_ = -1;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        last_[i] = bounds[i] < start.limit ? bounds[i] : 0;
        const double coupling = shell::couplings[i];
        if (coupling > 0 && free_edges_.too_near) continue;
        const double bound = coupling > 0 ? with_free_edges(bounds[i], coupling, start) : bounds[i];
        if (bound < start.limit && bound < least) {
            least = bound;
            best_ = static_cast<int>(i);
        }
    }
    if (best_ >= 0) {
        const auto best = static_cast<std::size_t>(best_);
        trigger_ = trigger_of(model, shell::couplings[best], bounds[best], comm);
    }
    ++attempts_;
    // Where nothing is won the attempts become rare: a yarn that has straightened stays so for long.
    will_wait_ = best_ >= 0 ? 1 : std::min(2 * will_wait_, longest_wait);
    waits_ = best_ >= 0 ? 0 : will_wait_;
    return least;
}

double TightStepBound::with_free_edges(double bound, double factor,
                                       const shell::TighteningStart& start) const {
    const double coupling = factor * coupling_at_rest_;
    if (!(coupling > 0)) return bound;
    const double inside = bound - std::max(start.hourglass, start.out_of_plane);
    const double at_edges = std::max(excess_on_edge(inside, coupling / free_edges_.edge),
                                     excess_at_corner(inside, coupling / free_edges_.corner));
    return std::max(bound + at_edges,
                    coupling / smallest_area_);  // of an eroded element, which keeps the term
}

shell::StiffeningTrigger TightStepBound::trigger_of(const Model& model, double coupling, double bound,
                                                    const parallel::Communicator& comm) const {
    std::array<double, 2> most{bound, any_packed(model) ? 1.0 : 0.0};
    for (const auto& group : model.groups)
        most[0] = std::max(most[0], shell::TightBound(*group).slack_frequency(coupling));
    comm.max(most);
    return {.slack_frequency = let_straighten * most[0], .coupling = coupling, .packing = most[1] == 0};
}

void TightStepBound::set_triggers(Model& model) const {
    for (const auto& group : model.groups)
        group->set_monitor(trigger_ ? shell::monitor_stiffening(*group, *trigger_) : nullptr);
}

}  // namespace weavefront::solver
