#include "weavefront/solver/step_bound.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "weavefront/fabric/constants.hpp"

namespace weavefront::solver {

namespace {

// A projectile so much heavier than the fabric under it stands still to the highest mode: far less than the
// safety factor leaves.
constexpr double negligible = 0.01;

// Sharper bounds are worth their use from this part of omega^2 on; a run goes on with the others otherwise.
// They come down to this part of the fabric's own omega^2: yarns of much crimp with fill and warp apart.
constexpr double worth_tightening = 0.85, least_in_plane = 0.4;

// The elements' normals are looked at where perfectly flat fabric would lower omega^2 by more than this
// factor; that costs a thirtieth of the elements' time.
constexpr double worth_looking = 1.05;

// A tighter bound falls by no more than this from one time to the next: what an element needs then is seldom
// computed, only compared with.
constexpr double follows_down = 0.98;

// In one attempt of so many the neighbours of the best coupling are tried, too.
constexpr int looks_beside = 8;

// As many times at most no attempt is made to tighten the bound, after others in vain.
constexpr int longest_wait = 32;

// Packing builds up within some ten steps. Where yarns are watched for it, and for straightening, the bound
// holds for longer.
constexpr std::int64_t steps_unwatched = 5, steps_while_watched = 10;

// Slack yarns may straighten until their omega^2 is so much above the bound before that is looked for anew:
// half of it is the step's, far less than the safety factor leaves.
constexpr double let_straighten = 1.03;

/// Of `springs` contact springs over a mass per area. @param reduced mass per area that the law's fraction of
/// critical damping refers to
ContactModes modes_of(const scene::ContactLaw& law, double springs, double mass, double reduced) {
    return {springs * law.unloading * law.stiffness / mass,
            springs * 2 * law.damping * std::sqrt(law.stiffness * reduced) / mass};
}

double coupling_at_rest(const scene::Scene& scene) {
    double largest = 0;
    for (const auto& fabric : scene.fabrics)
        largest = std::max(largest,
                           4 * fabric::coupling_at_rest(fabric::constants_of(fabric)) / fabric.areal_density);
    return largest;
}

/// Square of the cosine between a force and a direction; of no force 1.
double facing(const Vec3& force, const Vec3& axis) {
    const double square = force.squaredNorm(), component = force.dot(axis);
    return square > 0 ? component * component / square : 1;
}

/// The edges of a line of elements that lie on an edge of the ply.
struct Ends {
    double shortest_end, shortest;  ///< m
    bool free;
    bool two_ends;
};

Ends ends_of(const std::vector<double>& line, bool symmetric, scene::Edge edge) {
    double shortest = line[1] - line[0];
    for (std::size_t i = 1; i + 1 < line.size(); ++i) shortest = std::min(shortest, line[i + 1] - line[i]);
    const double last = line[line.size() - 1] - line[line.size() - 2];
    return {symmetric ? last : std::min(last, line[1] - line[0]), shortest, edge != scene::Edge::fixed,
            !symmetric};
}

}  // namespace

ContactModes contact_modes(const scene::Scene& scene) {
    double lightest = std::numeric_limits<double>::max();
    for (const auto& ply : scene.target->plies)
        lightest = std::min(lightest, scene.fabrics[static_cast<std::size_t>(ply.fabric)].areal_density);
    ContactModes sum;
    const auto add = [&](const ContactModes& modes) {
        sum.stiffness += modes.stiffness, sum.damping += modes.damping;
    };
    const auto plies = static_cast<double>(scene.target->plies.size());
    if (scene.contact.plies && plies > 1)
        add(modes_of(*scene.contact.plies, 4 * std::pow(std::cos(std::numbers::pi / (2 * plies)), 2),
                     lightest, lightest / 2));
    if (scene.contact.projectile && scene.projectile) {
        const double radius = scene.projectile->diameter / 2,
                     mass = scene.projectile->mass / (std::numbers::pi * radius * radius);
        const bool counts = lightest > negligible * mass;
        add(modes_of(*scene.contact.projectile, counts ? 1 + lightest / mass : 1, lightest, lightest));
        if (counts && scene.target->frame) add(modes_of(*scene.contact.projectile, 1, mass, mass));
    }
    if (scene.target->frame) add(modes_of(scene.contact.frame, 1, lightest, lightest));
    return sum;
}

double joint_frequency_squared(double in_plane, double out_of_plane, double contact, double sine_squared) {
    if (out_of_plane >= in_plane) return out_of_plane + contact;
    const double half = (in_plane - out_of_plane - contact) / 2;
    return (in_plane + out_of_plane + contact) / 2 +
           std::sqrt(half * half + contact * (in_plane - out_of_plane) * sine_squared);
}

// From above, by the case that all act in one direction; each turn brings it nearer to the solution and
// leaves it above.
double damped_frequency_squared(double in_plane, double out_of_plane, const ContactModes& contact,
                                double sine_squared) {
    const double half = contact.damping / 2;
    double omega = half + std::sqrt(half * half + std::max(in_plane, out_of_plane) + contact.stiffness);
    constexpr int turns = 8;
    for (int i = 0; i < turns && contact.damping > 0; ++i)
        omega = std::sqrt(joint_frequency_squared(in_plane, out_of_plane,
                                                  contact.stiffness + omega * contact.damping, sine_squared));
    return contact.damping > 0
               ? omega * omega
               : joint_frequency_squared(in_plane, out_of_plane, contact.stiffness, sine_squared);
}

double in_plane_of_joint(double joint, double out_of_plane, double contact, double sine_squared) {
    if (sine_squared == 1) return joint - contact;
    const double cosine_squared = 1 - sine_squared, rest = joint - out_of_plane - contact * cosine_squared;
    return rest > 0 ? joint - contact * sine_squared * (1 + contact * cosine_squared / rest) : 0;
}

// The gradients of an element see one half of a node's displacement: the corners' values less their mean and
// their hourglass mode. An edge couples x of one node with y of the next, both half seen: eigenvalue of {{a +
// l/4, l/4}, {l/4, l/4}}, a inside, l the coupling.
double excess_on_edge(double inside, double coupling) {
    const double a = std::max(inside, 0.0);
    return coupling / 4 - a / 2 + std::sqrt(a * a / 4 + coupling * coupling / 16);
}

// At a corner it couples the corner node, half seen, with the difference of its neighbours, wholly seen:
// {{a, 0, l/2}, {0, 0, l/2}, {l/2, l/2, a}}, whose largest eigenvalue a + x solves x^2 = l^2/4 (a + 2 x)/(a +
// x). From above.
double excess_at_corner(double inside, double coupling) {
    const double a = std::max(inside, 0.0);
    double x = coupling / std::numbers::sqrt2;
    for (int i = 0; i < 6 && x > 0; ++i) x = coupling / 2 * std::sqrt((a + 2 * x) / (a + x));
    return x;
}

StepBound::FreeEdges StepBound::free_edges(const mesh::Panel& panel) {
    const Ends x = ends_of(panel.x, panel.symmetry[0], panel.edges[0]),
               y = ends_of(panel.y, panel.symmetry[1], panel.edges[1]);
    FreeEdges edges;
    if (x.free) edges.edge = x.shortest_end * y.shortest;
    if (y.free) edges.edge = std::min(edges.edge, x.shortest * y.shortest_end);
    if (x.free && y.free) edges.corner = x.shortest_end * y.shortest_end;
    edges.too_near =
        (x.free && x.two_ends && panel.columns_x() < 2) || (y.free && y.two_ends && panel.columns_y() < 2);
    return edges;
}

StepBound::StepBound(const scene::Scene& scene, const mesh::Panel& panel)
    : corners_{panel.columns_x(), panel.nodes_per_ply() - 1, panel.nodes_per_ply() - 1 - panel.columns_x()},
      symmetry_(panel.symmetry),
      contact_(contact_modes(scene)),
      coupling_at_rest_(coupling_at_rest(scene)),
      smallest_area_(ends_of(panel.x, false, panel.edges[0]).shortest *
                     ends_of(panel.y, false, panel.edges[1]).shortest),
      free_edges_(free_edges(panel)) {}

// By three corners it turns with the ply, and all ranks get the same bits. It lies in planes of symmetry, as
// the mean normal does.
Vec3 StepBound::axis_of(const Model& model, const parallel::Communicator& comm) const {
    std::array<std::int64_t, 9> bits{};
    for (std::size_t k = 0; k < corners_.size(); ++k) {
        const auto at = std::ranges::lower_bound(model.nodes.ids, corners_[k]);
        const auto n = static_cast<std::size_t>(at - model.nodes.ids.begin());
        if (at == model.nodes.ids.end() || *at != corners_[k] || !model.nodes.owned[n]) continue;
        for (std::size_t d = 0; d < 3; ++d)
            bits[3 * k + d] = std::bit_cast<std::int64_t>(model.nodes.x[n][static_cast<Eigen::Index>(d)]);
    }
    comm.sum(bits);
    const auto corner = [&](std::size_t k) {
        return Vec3(std::bit_cast<double>(bits[3 * k]), std::bit_cast<double>(bits[3 * k + 1]),
                    std::bit_cast<double>(bits[3 * k + 2]));
    };
    Vec3 axis = (corner(1) - corner(0)).cross(corner(2) - corner(1));
    for (int d = 0; d < 2; ++d)
        if (symmetry_[static_cast<std::size_t>(d)]) axis[d] = 0;
    return axis.normalized();
}

// Normals and directions of contact stand within some angle of the axis, so within twice that of each other.
double StepBound::sine_squared_to_contact(const Model& model, const Vec3& axis,
                                          std::span<const contact::PairForce> pairs,
                                          const parallel::Communicator& comm) {
    constexpr double at_45_degrees = 0.5;
    double least = 1;
    for (const auto& group : model.groups)
        least = group->least_facing(model.nodes.x, axis, least, at_45_degrees);
    for (const auto& pair : pairs)
        if (pair.kind != contact::Master::facet)
            for (const auto& force : pair.on_slave) least = std::min(least, facing(force, axis));
    const double cosine_squared = comm.min(least);
    return cosine_squared > at_45_degrees ? 4 * cosine_squared * (1 - cosine_squared) : 1;
}

double StepBound::frequency_squared(const Model& model, std::span<const contact::PairForce> pairs,
                                    const parallel::Communicator& comm) {
    enum Most : std::size_t { in_plane, out_of_plane, hourglass, crimped, packed, size };
    std::array<double, size> most{};
    const auto raise = [&](Most which, double value) { most[which] = std::max(most[which], value); };
    for (const auto& group : model.groups) {
        const auto of_group = group->frequencies();
        raise(in_plane, of_group.in_plane);
        raise(out_of_plane, of_group.out_of_plane);
        raise(hourglass, of_group.hourglass);
        raise(crimped, group->is_crimped() ? 1 : 0);
        raise(packed, group->is_packed() ? 1 : 0);
    }
    comm.max(most);
    const auto joint = [&](double membrane, double sine_squared) {
        return damped_frequency_squared(membrane, most[out_of_plane], contact_, sine_squared);
    };
    const bool flat_pays =
        contact_.stiffness > 0 && joint(most[in_plane], 1) > worth_looking * joint(most[in_plane], 0);
    const Vec3 axis = flat_pays || most[crimped] > 0 ? axis_of(model, comm) : Vec3::UnitZ();
    const double sine_squared = flat_pays ? sine_squared_to_contact(model, axis, pairs, comm) : 1;
    trigger_ = {};
    const double worth = worth_tightening * joint(most[in_plane], sine_squared);
    const bool may_pay = (most[crimped] > 0 || most[packed] > 0) &&
                         joint(least_in_plane * most[in_plane], sine_squared) < worth;
    if (may_pay && --waits_ < 0) {
        const double contact = contact_.stiffness + std::sqrt(worth) * contact_.damping;
        const double limit = in_plane_of_joint(worth, most[out_of_plane], contact, sine_squared);
        shell::TighteningStart start{{}, limit, most[out_of_plane], most[hourglass], axis};
        // The coupling of an element that leans over mixes motion in its plane and out of it: only where
        // contact does not need them apart.
        choose_couplings(sine_squared == 1 && most[crimped] > 0, start);
        most[in_plane] = tightened(model, start, most[in_plane], comm);
    }
    trigger_.packing = trigger_.slack < std::numeric_limits<double>::infinity() && most[packed] == 0;
    steps_to_next_ = trigger_.packing ? steps_while_watched : steps_unwatched;
    return shell::in_steps(joint(most[in_plane], sine_squared));
}

void StepBound::choose_couplings(bool others_than_none, shell::TighteningStart& start) const {
    const auto may_help = [&](double coupling) { return coupling == 0 || others_than_none; };
    const bool starts_anew = best_ < 0 || !may_help(shell::couplings[static_cast<std::size_t>(best_)]);
    for (std::size_t i = 0; i < start.least.size(); ++i) {
        const int apart = std::abs(static_cast<int>(i) - best_);
        const bool is_due = starts_anew || apart == 0 || (attempts_ % looks_beside == 0 && apart == 1);
        const bool tried = is_due && may_help(shell::couplings[i]);
        const double known = best_ < 0 ? 0 : follows_down * last_[i];
        start.least[i] = tried ? std::clamp(known, start.limit * 0x1p-20, start.limit) : start.limit;
    }
}

double StepBound::tightened(const Model& model, const shell::TighteningStart& start, double held,
                            const parallel::Communicator& comm) {
    shell::TightBounds bounds = start.least;
    for (const auto& group : model.groups) group->tighten(start, model.nodes.x, bounds);
    comm.max(bounds);
    for (std::size_t i = 0; i < last_.size(); ++i) last_[i] = bounds[i] < start.limit ? bounds[i] : 0;
    double least = held;
    best_ = -1;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        double bound = bounds[i];
        if (const double coupling = shell::couplings[i] * coupling_at_rest_; coupling > 0) {
            if (free_edges_.too_near) continue;
            const double inside = bound - std::max(start.hourglass, start.out_of_plane);
            bound += std::max(excess_on_edge(inside, coupling / free_edges_.edge),
                              excess_at_corner(inside, coupling / free_edges_.corner));
            bound = std::max(bound, coupling / smallest_area_);  // of an eroded element, which keeps the term
        }
        if (bound < start.limit && bound < least) {
            least = bound;
            best_ = static_cast<int>(i);
        }
    }
    if (best_ >= 0) {
        const auto best = static_cast<std::size_t>(best_);
        double slack = bounds[best];
        for (const auto& group : model.groups)
            slack = std::max(slack, group->slack_frequency(shell::couplings[best]));
        trigger_ = {.slack = let_straighten * comm.max(slack), .coupling = shell::couplings[best]};
    }
    ++attempts_;
    // Where nothing is won the attempts become rare: a yarn that has straightened stays so for long.
    will_wait_ = best_ >= 0 ? 1 : std::min(2 * will_wait_, longest_wait);
    waits_ = best_ >= 0 ? 0 : will_wait_;
    return least;
}

void StepBound::set_triggers(Model& model) const {
    for (const auto& group : model.groups) group->set_trigger(trigger_);
}

}  // namespace weavefront::solver
