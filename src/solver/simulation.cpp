#include "weavefront/solver/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "diagnosis.hpp"
#include "free_edges.hpp"
#include "misses.hpp"
#include "weavefront/solver/central_difference.hpp"
#include "weavefront/solver/guard.hpp"
#include "weavefront/solver/motion.hpp"
#include "weavefront/solver/redistribution.hpp"

namespace weavefront::solver {

namespace {

// Packs whose forces are buffered between the kernel and the sums: small enough for the second-level cache.
constexpr std::int32_t packs_at_once = 64;

// A search lists the facets that may come within this distance, the skin, in edges of the smallest element. A
// larger skin means longer lists and fewer searches.
constexpr double skin_in_edges = 0.75;

// Candidates hold while each node stays within half of the skin of its swept bounds. A search becomes due
// this part of the skin earlier, since one more step is taken before the search.
constexpr double kept_of_skin = 0.125;

// Ghosts are taken from this much farther than the next search needs, in edges of the smallest element. In
// the 267 m/s example, 3 % more ghosts then last for about five searches. In a mesh as fine as the reach, the
// distance may cost a layer of columns: three instead of two at 0.5 mm.
constexpr double ghost_spare_in_edges = 0.5;

// The swept bounds of a node cover the way that it would take in so many steps.
constexpr double steps_ahead = 40;

// In so many steps the projectile moves by a small part of its radius.
constexpr std::int64_t steps_between_passages = 20;

// Strain of the stiffest yarns up to which the ledger resolves what they store.
constexpr double ledger_strain = 0.1;

// A time step not more than this factor below its bound is kept: a change costs new relaxation coefficients.
constexpr double worth_raising = 1.05;

double mass_of(const scene::Scene& scene) {
    double density = 0;
    for (const auto& ply : scene.target->plies)
        density += scene.fabrics[static_cast<std::size_t>(ply.fabric)].areal_density;
    return density * scene.target->size[0] * scene.target->size[1];
}

/// What the target can take: it moves as fast as the projectile, and all its yarns are strained far. J
double most_energy_of_target(const scene::Scene& scene, double speed) {
    double of_area = 0;
    for (const auto& ply : scene.target->plies) {
        const auto& fabric = scene.fabrics[static_cast<std::size_t>(ply.fabric)];
        for (const auto& system : fabric.systems())
            of_area += system.yarn.area / system.spacing * system.elastic.hooke_modulus * ledger_strain *
                       ledger_strain / 2;
    }
    return mass_of(scene) * speed * speed / 2 + of_area * scene.target->size[0] * scene.target->size[1];
}

}  // namespace

double ghost_reach(const scene::Scene& scene, const mesh::Panel& panel) {
    const double skin_and_spare = (skin_in_edges + ghost_spare_in_edges) * panel.smallest_edge();
    if (!scene.contact.plies || panel.plies.size() < 2) {
        // The smoothed normals of a rank's own nodes take the facets around them.
        const bool integrated =
            scene.contact.spacing &&
            ((scene.contact.projectile && !scene.projectiles.empty()) || scene.target->frame);
        return integrated ? skin_and_spare : 0;
    }
    double thickest = 0;
    for (const auto& ply : panel.plies)
        thickest = std::max(thickest, scene.fabrics[static_cast<std::size_t>(ply.fabric)].contact_thickness);
    return contact::ContactDistances::max_penetration_of(thickest) + skin_and_spare;
}

Simulation::Simulation(const scene::Scene& scene, const parallel::Communicator& comm)
    : scene_(scene),
      comm_(comm),
      shared_memory_(comm),
      panel_(mesh::make_panel(scene)),
      model_(build_model(scene, panel_,
                         initial_decomposition(scene, panel_, ghost_reach(scene, panel_), comm), comm)),
      multiplicity_(panel_.multiplicity()),
      step_bound_(scene, panel_) {
    model_.exchange.use(comm_, shared_memory_);
    pack_forces_.resize(static_cast<std::size_t>(packs_at_once) * shell::forces_per_pack);
    counts_.first_break.assign(panel_.plies.size(), std::numeric_limits<double>::max());
    double fastest = 0;
    for (const auto& projectile : model_.projectiles) {
        shots_.push_back({.initial = projectile.body, .passages = Passages(panel_.plies.size())});
        ledger_.initial_energy += projectile.body.kinetic_energy({}, 0);
        fastest = std::max(fastest, projectile.fastest_point());
    }
    agreement_.on_projectiles.resize(shots_.size());
    // A heavy projectile keeps most of its energy: the sums resolve what it can hand over.
    if (!shots_.empty())
        ledger_.energy_scale = std::min(ledger_.initial_energy, most_energy_of_target(scene, fastest));
    list_supports();
    ledger_.scale = parallel::FixedPoint(ledger_.energy_scale > 0 ? ledger_.energy_scale : 1);
    ledger_.mass_scale = parallel::FixedPoint(mass_of(scene));
    ledger_.has_contact_friction = scene.has_contact_friction();
    adapt_time_step();
    update_candidates();
    seconds_ = {};  // phases are those of the steps
}

void Simulation::advance_forces() {
    agreement_.clear();
    model_.assembly.start(model_.nodes.force);
    advance_elements();
    evaluate_contact();
    sum_forces_and_agree();
    apply_agreement();
    hold_supports();
    if (clock_.steps >= next_adaptation_ || agreement_.adaptation_due > 0) adapt_time_step();
    look_for_passages();
}

void Simulation::integrate() {
    {
        const Timed timed(seconds_, Phase::integrate);
        move_nodes();
        // The contact forces of this step include the facets of elements that eroded in it.
        for (const auto element : just_eroded_) model_.surface.alive[static_cast<std::size_t>(element)] = 0;
        just_eroded_.clear();
    }
    if (search_.is_outdated) update_candidates();
}

void Simulation::redistribute(const partition::Decomposition& decomposition) {
    {
        const Timed timed(seconds_, Phase::halo);
        model_ = solver::redistribute(scene_, panel_, decomposition, model_, comm_);
        model_.exchange.use(comm_, shared_memory_);
        follow_model();
    }
    update_candidates();
}

/// What depends on the elements and nodes that this rank holds.
void Simulation::follow_model() {
    for (const auto& group : model_.groups) group->set_time_step(clock_.dt);
    step_bound_.set_triggers(model_);
    contact_.clear();
    list_supports();
    joined_at_ = -1;
}

void Simulation::advance_elements() {
    const Timed timed(seconds_, Phase::elements);
    shell::Events events;
    for (const auto& group : model_.groups)
        for (std::int32_t first = 0; first < group->packs(); first += packs_at_once) {
            const auto count = std::min(packs_at_once, group->packs() - first);
            group->advance(first, count, model_.nodes.x, pack_forces_, events);
            model_.assembly.add_packs(*group, first, count, pack_forces_, model_.nodes.force);
        }
    record_events(events);
}

void Simulation::record_events(const shell::Events& events) {
    counts_.broken_yarns += events.broken_fill + events.broken_warp;
    counts_.eroded_elements += static_cast<std::int64_t>(events.eroded.size());
    for (const auto element : events.broken) {
        auto& first = counts_.first_break[static_cast<std::size_t>(
            model_.surface.facets[static_cast<std::size_t>(element)].ply)];
        first = std::min(first, clock_.time);
    }
    for (const double lost : events.lost_hourglass) ledger_.add(ledger_.eroded_hourglass, lost);
    for (const auto& erosion : events.eroded) {
        just_eroded_.push_back(erosion.element);
        model_.eroded.emplace(erosion.element, model_.output(erosion.element));
        ledger_.add(ledger_.eroded_work, erosion.work);
        ledger_.add(ledger_.eroded_friction, erosion.friction);
        ledger_.add(ledger_.eroded_hourglass, erosion.hourglass);
    }
}

void Simulation::evaluate_contact() {
    const Timed timed(seconds_, Phase::contact);
    const auto& nodes = model_.nodes;
    auto& normals = model_.normals;
    contact_.clear();
    normals.invalidate();
    const auto sliding_share = [&](ContactKind kind) { return sliding_[kind].sliding_share(); };
    for (auto& projectile : model_.projectiles)
        if (projectile.contact)
            projectile.contact->evaluate(model_.surface, normals, nodes.x, nodes.v, projectile.body,
                                         clock_.last_dt, sliding_share(of_projectile), contact_);
    book_sliding(of_projectile);
    if (model_.ply_contact)
        model_.ply_contact->evaluate(model_.surface, normals, nodes.x, nodes.v, clock_.last_dt,
                                     sliding_share(of_plies), contact_);
    book_sliding(of_plies);
    if (model_.frame_contact)
        model_.frame_contact->evaluate(model_.surface, normals, nodes.x, nodes.v, clock_.last_dt,
                                       sliding_share(of_frame), contact_);
    book_sliding(of_frame);
    for (const auto* pairs : {&contact_.pairs, &contact_.friction})
        for (const auto& pair : *pairs) {
            FixedVector* on_master = nullptr;
            if (pair.kind == contact::Master::projectile)
                on_master = &agreement_.on_projectiles[pair.projectile].force;
            model_.assembly.add_pair(pair, model_.nodes.force, on_master);
        }
    for (const auto* moments : {&contact_.moments, &contact_.friction_moments})
        for (const auto& [moment, projectile] : *moments)
            model_.assembly.add_moment(moment, agreement_.on_projectiles[projectile].moment);
    add_clamp_forces();
    for (std::size_t p = 0; p < shots_.size(); ++p) {
        auto& projectile = model_.projectiles[p];
        if (!projectile.on_frame) continue;
        const auto of_whole = projectile.on_frame->evaluate(projectile.body, clock_.last_dt);
        shots_[p].from_frame = {without_mirrored(of_whole.pressure), without_mirrored(of_whole.friction)};
    }
    add_half_step_contact_work(clock_.last_dt);
    contact_.deepest.time = clock_.time;
    counts_.deepest.include(contact_.deepest);
}

/// A node counts on the rank that owns it.
void Simulation::add_clamp_forces() {
    if (!model_.clamp_friction) return;
    model_.clamp_friction->evaluate(model_.nodes.v, clock_.last_dt);
    for (const auto& [node, force] : model_.clamp_friction->forces())
        if (model_.nodes.owned[node]) model_.assembly.add_force(force, model_.nodes.force[node]);
}

void Simulation::book_sliding(ContactKind kind) {
    for (const auto& facet : contact_.sliding) {
        ledger_.add(agreement_.sliding_released[kind], facet.released - facet.taken);
        ledger_.add(agreement_.sliding_wanted[kind], facet.wanted);
    }
    contact_.sliding.clear();
}

/// The force at a time works half of a step with the velocity before it, half with the velocity after it.
void Simulation::add_half_step_contact_work(double dt) {
    add_contact_work(ledger_.contact, contact_.pairs, contact_.moments, dt);
    if (ledger_.has_contact_friction)
        add_contact_work(ledger_.contact_friction, contact_.friction, contact_.friction_moments, dt);
    for (std::size_t p = 0; p < shots_.size(); ++p) {
        const auto& body = model_.projectiles[p].body;
        add_frame_work(ledger_.contact, body, shots_[p].from_frame.pressure, dt);
        add_frame_work(ledger_.contact_friction, body, shots_[p].from_frame.friction, dt);
    }
    if (!model_.clamp_friction) return;
    for (const auto& [node, force] : model_.clamp_friction->forces())
        if (model_.nodes.owned[node])
            ledger_.add(ledger_.contact_friction, -force.dot(model_.nodes.v[node]) * dt / 2);
}

void Simulation::add_contact_work(std::int64_t& taken, std::span<const contact::PairForce> pairs,
                                  std::span<const contact::MomentOnProjectile> moments, double dt) {
    const auto& v = model_.nodes.v;
    const auto& projectiles = model_.projectiles;
    for (const auto& pair : pairs) {
        double power = pair.kind == contact::Master::projectile
                           ? -pair.total.dot(projectiles[pair.projectile].body.velocity())
                           : 0;
        for (std::size_t a = 0; a < 4; ++a) {
            power += pair.on_slave[a].dot(v[static_cast<std::size_t>(pair.slave[a])]);
            if (pair.kind == contact::Master::facet)
                power += pair.on_master[a].dot(v[static_cast<std::size_t>(pair.master[a])]);
        }
        ledger_.add(taken, -power * dt / 2);
    }
    for (const auto& [moment, projectile] : moments)
        ledger_.add(taken, -moment.dot(projectiles[projectile].body.angular_velocity()) * dt / 2);
}

/// The frame's force is that of the whole target, which the ledger has from its part.
void Simulation::add_frame_work(std::int64_t& taken, const body::RigidBody& projectile,
                                const body::Wrench& from_frame, double dt) {
    if (from_frame.force == Vec3::Zero() || comm_.rank() != 0) return;
    double power = from_frame.force.dot(projectile.velocity());
    if (projectile.turns()) power += from_frame.moment.dot(projectile.angular_velocity());
    ledger_.add(taken, -power * dt / 2 / multiplicity_);
}

/// Sums the forces of shared nodes and the integers of the step. The exchange of forces runs during the
/// all-reduce. Every rank that holds a node, ghosts included, receives its full force and moves it by itself.
void Simulation::sum_forces_and_agree() {
    const Timed timed(seconds_, Phase::halo);
    model_.exchange.start(comm_, model_.nodes.force);
    const auto has_stiffened = [](const auto& group) { return group->has_stiffened(); };
    agreement_.eroded = static_cast<std::int64_t>(just_eroded_.size());
    agreement_.left_skin = moved_far() ? 1 : 0;
    agreement_.adaptation_due = std::ranges::any_of(model_.groups, has_stiffened) ? 1 : 0;
    agreement_.stop = stop_requested_ ? 1 : 0;
    agreement_.checkpoint = std::exchange(checkpoint_requested_, false) ? 1 : 0;
    agreement_.fault =
        model_.assembly.faulty_element() >= 0 || model_.assembly.faulty_contact() || ledger_.is_faulty;
    agreement_.sum(comm_);
    model_.exchange.finish(model_.nodes.force);
}

void Simulation::apply_agreement() {
    for (std::size_t kind = 0; kind < contact_kinds; ++kind)
        sliding_[kind].book(agreement_.sliding_released[kind], agreement_.sliding_wanted[kind]);
    for (std::size_t p = 0; p < shots_.size(); ++p) {
        auto& shot = shots_[p];
        const auto& on_part = agreement_.on_projectiles[p];
        const auto from_fabric = without_mirrored({multiplicity_ * model_.assembly.value(on_part.force),
                                                   multiplicity_ * model_.assembly.moment(on_part.moment)});
        const auto& [pressure, friction] = shot.from_frame;
        shot.wrench = {from_fabric.force + pressure.force + friction.force,
                       from_fabric.moment + pressure.moment + friction.moment};
        if (shot.wrench.force != Vec3::Zero()) shot.touched = true, shot.last_touched = clock_.time;
    }
    search_.any_eroded = search_.any_eroded || agreement_.eroded > 0;
    search_.is_outdated = agreement_.eroded > 0 || agreement_.left_skin > 0;
    if (agreement_.fault == 0) return;
    // The state before these forces is shown.
    std::ranges::fill(model_.nodes.force, FixedVector{});
    for (auto& shot : shots_) shot.wrench = {};
    stop_at_fault();
}

void Simulation::stop_at_fault() const {
    const auto element = faulty_element();
    const auto limit = 1024 * model_.assembly.scale().quantum() * 0x1p44;
    const auto where =
        element < 0 ? std::string("a contact point or a breaking element") : place_of(panel_, element);
    throw GuardStop(fmt::format("the force of {} is not finite or above {:.3g} N at t = {:.6g} us, step {}: "
                                "the deformation has become unstable",
                                where, limit, clock_.time * 1e6, clock_.steps),
                    Fault::force);
}

/// The mirror image pushes back, and turns back about every axis but the normal of the plane of symmetry.
body::Wrench Simulation::without_mirrored(body::Wrench wrench) const {
    for (int plane = 0; plane < 2; ++plane) {
        if (!panel_.symmetry[static_cast<std::size_t>(plane)]) continue;
        wrench.force[plane] = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (axis != plane) wrench.moment[axis] = 0;
    }
    return wrench;
}

void Simulation::adapt_time_step() {
    const Timed timed(seconds_, Phase::elements);
    const double omega_squared = step_bound_.frequency_squared(model_, contact_.pairs, comm_);
    step_bound_.set_triggers(model_);
    next_adaptation_ = clock_.steps + step_bound_.steps_to_next();
    const double bound = scene_.time.safety * 2 / std::sqrt(omega_squared);
    if (!(bound > 0))
        throw GuardStop(
            fmt::format("the time step vanished at t = {:.6g} us, step {}", clock_.time * 1e6, clock_.steps));
    if (clock_.dt > 0 && clock_.dt <= bound && bound < worth_raising * clock_.dt) return;
    clock_.dt = bound;
    for (const auto& group : model_.groups) group->set_time_step(clock_.dt);
}

void Simulation::list_supports() {
    held_.clear();
    for (std::size_t n = 0; n < model_.nodes.supports.size(); ++n)
        if (model_.nodes.supports[n] != 0) held_.push_back(n);
}

void Simulation::hold_supports() {
    for (const auto n : held_)
        for (std::size_t d = 0; d < 3; ++d)
            if (model_.nodes.supports[n] & (1U << d)) model_.nodes.force[n][d] = 0;
}

Vec3 Simulation::updated_velocity(std::size_t node) const {
    const auto& v = model_.nodes.v[node];
    const Vec3 acceleration = model_.assembly.value(model_.nodes.force[node]) / model_.nodes.mass[node];
    const double step = clock_.velocity_step(), drag = scene_.damping * step / 2;
    return drag == 0 ? next_velocity(v, acceleration, step) : next_velocity(v, acceleration, step, drag);
}

void Simulation::move_nodes() {
    auto& nodes = model_.nodes;
    if (scene_.damping > 0) {
        for (std::size_t n = 0; n < nodes.x.size(); ++n) {
            const Vec3 next = updated_velocity(n);
            if (n < nodes.owned.size() && nodes.owned[n])
                ledger_.add(ledger_.damping, damping_work(n, next, clock_.last_dt, clock_.dt));
            nodes.v[n] = next;
            nodes.x[n] += clock_.dt * next;
        }
    } else {
        move_freely(nodes, model_.assembly.scale(), clock_.velocity_step(), clock_.dt);
    }
    for (std::size_t p = 0; p < shots_.size(); ++p)
        model_.projectiles[p].body.accelerate(shots_[p].wrench, clock_.velocity_step());
    add_half_step_contact_work(clock_.dt);
    for (auto& projectile : model_.projectiles) projectile.body.move(clock_.dt);
    clock_.advance();
    for (std::size_t p = 0; p < shots_.size(); ++p)
        if (!shots_[p].turned_back && model_.projectiles[p].body.velocity().z() <= 0)
            shots_[p].turned_back = clock_.time;
}

void Simulation::look_for_passages() {
    if (clock_.steps % steps_between_passages != 0) return;
    if (shots_.size() > 1) projectile_overlap_.look(model_.projectiles, clock_.time);
    if (!model_.has_projectile_contact()) return;
    for (std::size_t p = 0; p < shots_.size(); ++p) {
        const auto& projectile = model_.projectiles[p];
        // In front of the first ply as it was, it has passed none.
        if (shots_[p].passages.all() || projectile.contact->middle(projectile.body).z() <= 0) continue;
        shots_[p].passages.look(model_, joined_fabric(), panel_, contact_.pairs, p, clock_.time, comm_);
    }
}

contact::Deepest Simulation::deepest() const { return deepest_of_all(counts_.deepest, comm_); }

CrossedElements Simulation::crossed_elements() const { return elements_behind_whole_plies(model_, comm_); }

bool Simulation::moved_far() const {
    if (search_.nodes.empty()) return false;
    const double margin = model_.smallest_edge * skin_in_edges * (0.5 - kept_of_skin);
    if (search_.nodes.any_outside(model_.nodes.own_x(), margin)) return true;
    return model_.has_projectile_contact() && search_.projectiles.any_outside(search_points(), margin);
}

std::span<const Vec3> Simulation::search_points() const {
    search_points_.clear();
    for (const auto& projectile : model_.projectiles)
        search_points_.push_back(projectile.contact->search_point(projectile.body));
    return search_points_;
}

void Simulation::update_candidates() {
    search_.is_outdated = false;
    if (!model_.has_projectile_contact() && !model_.ply_contact && !model_.frame_contact) return;
    const Timed timed(seconds_, Phase::search);
    ++counts_.searches;
    const double skin = skin_in_edges * model_.smallest_edge, ahead = steps_ahead * clock_.dt;
    auto& nodes = model_.nodes;
    search_.nodes = contact::SweptBounds(nodes.x, nodes.v, ahead);
    if (search_.any_eroded) find_free_edges(comm_, panel_, model_);
    const double reach = ghost_reach(scene_, panel_), spare = ghost_spare_in_edges * panel_.smallest_edge();
    if (reach > 0 && model_.ghosts.renew(comm_, model_.halo, search_.nodes, reach, spare, model_.surface,
                                         nodes, model_.exchange)) {
        model_.exchange.use(comm_, shared_memory_);
        search_.nodes = contact::SweptBounds(nodes.x, nodes.v, ahead);
        list_supports();
        model_.normals.rebuild(model_.surface, nodes.x.size());
    }
    if (model_.ply_contact)
        model_.ply_contact->update_candidates(model_.surface, search_.nodes, nodes.x, skin);
    if (model_.has_projectile_contact()) {
        const auto points = search_points();
        std::vector<Vec3> velocities;
        for (std::size_t p = 0; p < points.size(); ++p)
            velocities.push_back(model_.projectiles[p].body.motion().at(points[p]));
        search_.projectiles = contact::SweptBounds(points, velocities, ahead);
        for (std::size_t p = 0; p < points.size(); ++p)
            model_.projectiles[p].contact->update_candidates(model_.surface, search_.nodes,
                                                             search_.projectiles.of_node(p), skin);
    }
    release_debris_nodes();
}

void Simulation::release_debris_nodes() {
    const auto& surface = model_.surface;
    std::vector<bool> in_fabric(static_cast<std::size_t>(model_.nodes.count), false);
    for (std::size_t f = 0; f < static_cast<std::size_t>(surface.owned); ++f)
        if (surface.alive[f])
            for (const auto node : surface.facets[f].nodes) in_fabric[static_cast<std::size_t>(node)] = true;
    for (std::size_t n = 0; n < in_fabric.size(); ++n)
        if (!in_fabric[n]) search_.nodes.ignore(n);
}

Vec3 Simulation::velocity(std::size_t node) const {
    const auto& v = model_.nodes.v[node];
    const Vec3 acceleration = acceleration_between(v, updated_velocity(node), clock_.velocity_step());
    return present_velocity(v, acceleration, clock_.last_dt);
}

Vec3 Simulation::projectile_velocity(std::size_t projectile) const {
    const auto& body = model_.projectiles[projectile].body;
    const Vec3 acceleration = shots_[projectile].wrench.force / body.mass();
    return present_velocity(body.velocity(), acceleration, clock_.last_dt);
}

Vec3 Simulation::projectile_angular_velocity(std::size_t projectile) const {
    const auto& body = model_.projectiles[projectile].body;
    return body.angular_velocity_of(
        present_velocity(body.angular_momentum(), shots_[projectile].wrench.moment, clock_.last_dt));
}

}  // namespace weavefront::solver
