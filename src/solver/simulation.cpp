#include "weavefront/solver/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "free_edges.hpp"
#include "misses.hpp"
#include "weavefront/solver/guard.hpp"
#include "weavefront/solver/motion.hpp"
#include "weavefront/solver/redistribution.hpp"

namespace weavefront::solver {

namespace {

// Packs whose forces are buffered between the kernel and the sums: small enough for the second-level cache.
constexpr std::int32_t packs_at_once = 64;

// Lists of what may meet hold what comes within this many edges of the smallest element: short lists against
// few renewals.
constexpr double skin_in_edges = 0.75;

// Footprints of facets may approach by the skin: each of a pair by half of it, less this part of all, kept
// for the step that is under way.
constexpr double kept_of_skin = 0.125;

// Ghosts are taken in from so much farther than they matter until the next search. In the 267 m/s example
// they last for about five searches then, for 3 % more of them; where the mesh is about as fine as the reach
// they may be a layer of columns more, three instead of two at 0.5 mm.
constexpr double ghost_spare_in_edges = 0.5;

// Nodes are expected anywhere on the way that they would take in so many steps.
constexpr double steps_ahead = 40;

// The projectile goes a small part of its radius in so many steps.
constexpr std::int64_t steps_between_passages = 20;

// Strain of the stiffest yarns up to which the ledger resolves what they store.
constexpr double ledger_strain = 0.1;

// A time step not more than this factor below its bound is kept: a change costs new relaxation coefficients.
constexpr double worth_raising = 1.05;

std::string place_of(const mesh::Panel& panel, std::int64_t element) {
    const auto corners = panel.footprint(element % panel.columns());
    const Vec3 centre = (panel.position(0, corners[0]) + panel.position(0, corners[2])) / 2;
    return fmt::format("element {} (ply {}, at x = {:.4g} mm, y = {:.4g} mm)", element,
                       element / panel.columns() + 1, centre.x() * 1e3, centre.y() * 1e3);
}

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
        of_area += fabric.yarn.area / fabric.yarn.span * fabric.elastic.hooke_modulus * ledger_strain *
                   ledger_strain;
    }
    return mass_of(scene) * speed * speed / 2 + of_area * scene.target->size[0] * scene.target->size[1];
}

}  // namespace

double ghost_reach(const scene::Scene& scene, const mesh::Panel& panel) {
    const double skin_and_spare = (skin_in_edges + ghost_spare_in_edges) * panel.smallest_edge();
    if (!scene.contact.plies || panel.plies.size() < 2) {
        // The smoothed normals of a rank's own nodes take the facets around them.
        const bool integrated =
            scene.contact.spacing && ((scene.contact.projectile && scene.projectile) || scene.target->frame);
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
      step_bound_(scene, panel_),
      passages_(panel_.plies.size()) {
    model_.exchange.use(comm_, shared_memory_);
    pack_forces_.resize(static_cast<std::size_t>(packs_at_once) * shell::forces_per_pack);
    counts_.first_break.assign(panel_.plies.size(), std::numeric_limits<double>::max());
    if (model_.projectile) {
        initial_projectile_ = model_.projectile->position;
        initial_energy_ = scene.projectile->mass * model_.projectile->velocity.squaredNorm() / 2;
        // A heavy projectile keeps most of its energy: the sums resolve what it can hand over.
        energy_scale_ =
            std::min(initial_energy_, most_energy_of_target(scene, model_.projectile->velocity.norm()));
    }
    list_supports();
    energy_ = parallel::FixedPoint(energy_scale_ > 0 ? energy_scale_ : 1);
    mass_scale_ = parallel::FixedPoint(mass_of(scene));
    adapt_time_step();
    update_candidates();
    seconds_ = {};  // phases are those of the steps
}

void Simulation::advance_forces() {
    model_.assembly.start(model_.nodes.force);
    advance_elements();
    evaluate_contact();
    sum_over_ranks();
    hold_supports();
    if (steps_ >= next_check_ || step_check_due_) adapt_time_step();
    look_for_passages();
}

void Simulation::integrate() {
    {
        const Timed timed(seconds_, Phase::integrate);
        move_nodes();
        count_contact_work(dt_);
        for (const auto element : just_eroded_) model_.surface.alive[static_cast<std::size_t>(element)] = 0;
        just_eroded_.clear();
    }
    if (candidates_outdated_) update_candidates();
}

void Simulation::redistribute(const partition::Decomposition& decomposition) {
    {
        const Timed timed(seconds_, Phase::halo);
        model_ = solver::redistribute(scene_, panel_, decomposition, model_, comm_);
        model_.exchange.use(comm_, shared_memory_);
        for (const auto& group : model_.groups) group->set_time_step(dt_);
        step_bound_.set_triggers(model_);
        contact_.clear();
        list_supports();
        joined_at_ = -1;
    }
    update_candidates();
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
        first = std::min(first, time_);
    }
    for (const double lost : events.lost_hourglass) add_energy(eroded_hourglass_, lost);
    for (const auto& erosion : events.eroded) {
        just_eroded_.push_back(erosion.element);
        model_.eroded.emplace(erosion.element, model_.output(erosion.element));
        add_energy(eroded_work_, erosion.work);
        add_energy(eroded_friction_, erosion.friction);
        add_energy(eroded_hourglass_, erosion.hourglass);
    }
}

void Simulation::add_energy(std::int64_t& sum, double energy) {
    if (energy_.fits(energy))
        sum += energy_.from(energy);
    else
        faulty_energy_ = true;
}

void Simulation::evaluate_contact() {
    const Timed timed(seconds_, Phase::contact);
    const auto& nodes = model_.nodes;
    auto& normals = model_.normals;
    contact_.clear();
    on_projectile_ = {};
    normals.new_positions();
    const auto share = [&](ContactKind kind) { return sliding_[kind].share(); };
    if (model_.projectile_contact)
        model_.projectile_contact->evaluate(model_.surface, normals, nodes.x, nodes.v, *model_.projectile,
                                            last_dt_, share(of_projectile), contact_);
    book_sliding(of_projectile);
    if (model_.ply_contact)
        model_.ply_contact->evaluate(model_.surface, normals, nodes.x, nodes.v, last_dt_, share(of_plies),
                                     contact_);
    book_sliding(of_plies);
    if (model_.frame_contact)
        model_.frame_contact->evaluate(model_.surface, normals, nodes.x, nodes.v, last_dt_, share(of_frame),
                                       contact_);
    book_sliding(of_frame);
    for (const auto& pair : contact_.pairs)
        model_.assembly.add_pair(pair, model_.nodes.force, on_projectile_);
    if (model_.projectile_on_frame)
        frame_force_ = without_mirrored(model_.projectile_on_frame->evaluate(*model_.projectile, last_dt_));
    count_contact_work(last_dt_);
    contact_.deepest.time = time_;
    counts_.deepest.include(contact_.deepest);
}

void Simulation::book_sliding(ContactKind kind) {
    sliding_released_[kind] = sliding_wanted_[kind] = 0;
    for (const auto& facet : contact_.sliding) {
        add_energy(sliding_released_[kind], facet.released - facet.taken);
        add_energy(sliding_wanted_[kind], facet.wanted);
    }
    contact_.sliding.clear();
}

void Simulation::count_contact_work(double dt) {
    const auto& v = model_.nodes.v;
    for (const auto& pair : contact_.pairs) {
        double power =
            pair.kind == contact::Master::projectile ? -pair.total.dot(model_.projectile->velocity) : 0;
        for (std::size_t a = 0; a < 4; ++a) {
            power += pair.on_slave[a].dot(v[static_cast<std::size_t>(pair.slave[a])]);
            if (pair.kind == contact::Master::facet)
                power += pair.on_master[a].dot(v[static_cast<std::size_t>(pair.master[a])]);
        }
        add_energy(contact_work_, -power * dt / 2);
    }
    if (frame_force_ != Vec3::Zero() &&
        comm_.rank() == 0)  // of the whole target, which the ledger has from its part
        add_energy(contact_work_, -frame_force_.dot(model_.projectile->velocity) * dt / 2 / multiplicity_);
}

void Simulation::sum_over_ranks() {
    const Timed timed(seconds_, Phase::halo);
    model_.exchange.start(comm_, model_.nodes.force);
    const bool faulty =
        model_.assembly.faulty_element() >= 0 || model_.assembly.faulty_contact() || faulty_energy_;
    const bool stiffened =
        std::ranges::any_of(model_.groups, [](const auto& group) { return group->has_stiffened(); });
    enum Sum : std::size_t {
        x,
        y,
        z,
        eroded,
        left,
        stiff,
        stop,
        fault,
        released,
        wanted = released + contact_kinds,
        size = wanted + contact_kinds
    };
    std::array<std::int64_t, size> sums{
        on_projectile_[0],      on_projectile_[1],
        on_projectile_[2],      static_cast<std::int64_t>(just_eroded_.size()),
        moved_far() ? 1 : 0,    stiffened ? 1 : 0,
        is_stop_asked_ ? 1 : 0, faulty ? 1 : 0};
    std::ranges::copy(sliding_released_, sums.begin() + released);
    std::ranges::copy(sliding_wanted_, sums.begin() + wanted);
    comm_.sum(sums);
    for (std::size_t kind = 0; kind < contact_kinds; ++kind)
        sliding_[kind].book(sums[released + kind], sums[wanted + kind]);
    model_.exchange.finish(model_.nodes.force);
    projectile_force_ =
        without_mirrored(multiplicity_ * model_.assembly.value({sums[x], sums[y], sums[z]})) + frame_force_;
    if (projectile_force_ != Vec3::Zero()) counts_.touched = true, counts_.last_touched = time_;
    any_eroded_ = any_eroded_ || sums[eroded] > 0;
    candidates_outdated_ = sums[eroded] > 0 || sums[left] > 0;
    step_check_due_ = sums[stiff] > 0;
    is_stop_agreed_ = sums[stop] > 0;
    if (sums[fault] > 0) {
        // What is shown is the state before these forces.
        std::ranges::fill(model_.nodes.force, FixedVector{});
        projectile_force_.setZero();
        stop_at_fault();
    }
}

void Simulation::stop_at_fault() const {
    constexpr auto none = std::numeric_limits<std::int64_t>::max();
    const auto local = model_.assembly.faulty_element();
    std::int64_t element = local < 0 ? none : model_.global.element_ids[static_cast<std::size_t>(local)];
    comm_.min({&element, 1});
    const auto limit = 1024 * model_.assembly.scale().quantum() * 0x1p44;
    const auto where =
        element == none ? std::string("a contact point or a breaking element") : place_of(panel_, element);
    throw GuardStop(
        fmt::format("the force of {} is not finite or above {:.3g} N at t = {:.6g} us, step {}: the "
                    "deformation has become unstable; "
                    "try a smaller time.safety",
                    where, limit, time_ * 1e6, steps_));
}

Vec3 Simulation::without_mirrored(Vec3 force) const {
    for (int d = 0; d < 2; ++d)
        if (panel_.symmetry[static_cast<std::size_t>(d)]) force[d] = 0;  // the mirror image pushes back
    return force;
}

void Simulation::adapt_time_step() {
    const Timed timed(seconds_, Phase::elements);
    const double omega_squared = step_bound_.frequency_squared(model_, contact_.pairs, comm_);
    step_bound_.set_triggers(model_);
    next_check_ = steps_ + step_bound_.steps_to_next();
    const double bound = scene_.time.safety * 2 / std::sqrt(omega_squared);
    if (!(bound > 0))
        throw GuardStop(fmt::format("the time step vanished at t = {:.6g} us, step {}", time_ * 1e6, steps_));
    if (dt_ > 0 && dt_ <= bound && bound < worth_raising * dt_) return;
    dt_ = bound;
    for (const auto& group : model_.groups) group->set_time_step(dt_);
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

void Simulation::move_nodes() {
    auto& nodes = model_.nodes;
    if (scene_.damping > 0) {
        for (std::size_t n = 0; n < nodes.x.size(); ++n) {
            const Vec3 next = updated_velocity(n);
            if (n < nodes.owned.size() && nodes.owned[n])
                add_energy(damping_work_, damping_work(n, next, last_dt_, dt_));
            nodes.v[n] = next;
            nodes.x[n] += dt_ * next;
        }
    } else {
        move_freely(nodes, model_.assembly.scale(), (last_dt_ + dt_) / 2, dt_);
    }
    if (model_.projectile) {
        model_.projectile->velocity += (last_dt_ + dt_) / 2 / scene_.projectile->mass * projectile_force_;
        model_.projectile->position += dt_ * model_.projectile->velocity;
    }
    time_ += dt_;
    if (model_.projectile && !counts_.turned_back && model_.projectile->velocity.z() <= 0)
        counts_.turned_back = time_;
    last_dt_ = dt_;
    ++steps_;
}

void Simulation::look_for_passages() {
    if (!model_.projectile_contact || steps_ % steps_between_passages != 0 || passages_.all()) return;
    const auto& projectile = *scene_.projectile;
    const double length = projectile.shape == scene::Shape::sphere ? projectile.diameter : projectile.length;
    const Vec3 middle = model_.projectile->position - Vec3(0, 0, length / 2);
    if (middle.z() <= 0) return;  // in front of the first ply as it was
    passages_.look(model_, joined_fabric(), panel_, contact_.pairs, middle, projectile.diameter / 2, time_,
                   comm_);
}

contact::Deepest Simulation::deepest() const { return deepest_of_all(counts_.deepest, comm_); }

CrossedElements Simulation::crossed_elements() const { return elements_behind_whole_plies(model_, comm_); }

bool Simulation::moved_far() const {
    if (swept_nodes_.empty()) return false;
    const double margin = model_.smallest_edge * skin_in_edges * (0.5 - kept_of_skin);
    return swept_nodes_.any_outside(model_.nodes.own_x(), margin) ||
           (model_.projectile_contact &&
            swept_projectile_.any_outside({&model_.projectile->position, 1}, margin));
}

void Simulation::update_candidates() {
    candidates_outdated_ = false;
    if (!model_.projectile_contact && !model_.ply_contact && !model_.frame_contact) return;
    const Timed timed(seconds_, Phase::search);
    ++counts_.searches;
    const double skin = skin_in_edges * model_.smallest_edge, ahead = steps_ahead * dt_;
    auto& nodes = model_.nodes;
    swept_nodes_ = contact::SweptBounds(nodes.x, nodes.v, ahead);
    if (any_eroded_) find_free_edges(comm_, panel_, model_);
    const double reach = ghost_reach(scene_, panel_), spare = ghost_spare_in_edges * panel_.smallest_edge();
    if (reach > 0 && model_.ghosts.renew(comm_, model_.halo, swept_nodes_, reach, spare, model_.surface,
                                         nodes, model_.exchange)) {
        model_.exchange.use(comm_, shared_memory_);
        swept_nodes_ = contact::SweptBounds(nodes.x, nodes.v, ahead);
        list_supports();
        model_.normals.rebuild(model_.surface, nodes.x.size());
    }
    if (model_.ply_contact)
        model_.ply_contact->update_candidates(model_.surface, swept_nodes_, nodes.x, skin);
    if (model_.projectile_contact) {
        auto& projectile = *model_.projectile;
        swept_projectile_ = contact::SweptBounds({&projectile.position, 1}, {&projectile.velocity, 1}, ahead);
        model_.projectile_contact->update_candidates(model_.surface, swept_nodes_,
                                                     swept_projectile_.of_node(0), skin);
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
        if (!in_fabric[n]) swept_nodes_.ignore(n);
}

Vec3 Simulation::velocity(std::size_t node) const {
    const Vec3 &v = model_.nodes.v[node],
               acceleration = (updated_velocity(node) - v) / ((last_dt_ + dt_) / 2);
    return v + last_dt_ / 2 * acceleration;
}

Vec3 Simulation::projectile_velocity() const {
    const Vec3 acceleration = projectile_force_ / scene_.projectile->mass;
    return model_.projectile->velocity + last_dt_ / 2 * acceleration;
}

}  // namespace weavefront::solver
