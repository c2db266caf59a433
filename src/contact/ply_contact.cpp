#include "weavefront/contact/ply_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "weavefront/contact/clearance_query.hpp"

namespace weavefront::contact {

namespace {

// Of the touching distance. A facet with less clear than is worth waiting for is evaluated in every step,
// until others have approached so far that looking again is worth while.
constexpr double worth_waiting_in_distance = 0.001, look_again_in_distance = 0.015;

// A facet waits for its own candidates rather than for those of its group where the group's last step would
// use up its clear in fewer steps than this: to follow its own for a step takes about a tenth of the time of
// a look.
constexpr double own_in_steps = 10;

std::array<Lanes, 4> shape_functions(const RayHits& hits) {
    std::array<Lanes, 4> N;
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double xi = hits.xi[i], eta = hits.eta[i];
        N[0][i] = (1 - xi) * (1 - eta) / 4;
        N[1][i] = (1 + xi) * (1 - eta) / 4;
        N[2][i] = (1 + xi) * (1 + eta) / 4;
        N[3][i] = (1 - xi) * (1 + eta) / 4;
    }
    return N;
}

// A distance along a line changes by no more than this times the way that one side moves past the other:
// lines meet facets at up to 60 deg.
constexpr double stretch_along_line = 2;

/// How the points have moved towards what their lines meet.
RelativeMotionLanes relative_motion(const VectorLanes& slave, const VectorLanes& master,
                                    const VectorLanes& direction) {
    RelativeMotionLanes motion;
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double x = slave.x[i] - master.x[i], y = slave.y[i] - master.y[i], z = slave.z[i] - master.z[i];
        motion.closing[i] = x * direction.x[i] + y * direction.y[i] + z * direction.z[i];
        motion.most[i] = stretch_along_line * std::sqrt(x * x + y * y + z * z);
    }
    return motion;
}

/// The first points of a batch, as many as it has.
LaneMask all_of(const QuadratureBatch& batch) {
    LaneMask mask{};
    std::fill_n(mask.begin(), batch.count, true);
    return mask;
}

}  // namespace

PlyContact::PlyContact(const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface,
                       std::span<const Vec3> x)
    : distances_(surface.plies),
      quadrature_(spacing, most_points_along_edge),
      relative_motion_(surface, x),
      culling_(static_cast<std::size_t>(surface.owned)),
      due_(static_cast<std::size_t>(relative_motion_.groups())),
      memory_(culling_.size()),
      dissipated_budgets_(culling_.size()) {
    // A law for each pair of plies would take room with the square of their number.
    std::vector<double> densities;
    for (const auto& ply : surface.plies) {
        const auto found = std::ranges::find(densities, ply.areal_density);
        weights_.push_back(static_cast<std::size_t>(found - densities.begin()));
        if (found == densities.end()) densities.push_back(ply.areal_density);
    }
    different_weights_ = densities.size();
    for (const double one : densities)
        for (const double other : densities) laws_.emplace_back(law, one * other / (one + other));
    rules_.reserve(culling_.size());
    for (std::size_t f = 0; f < culling_.size(); ++f)
        rules_.push_back(
            static_cast<std::uint8_t>(quadrature_.rule_for(corners_of(surface.facets[f].nodes, x))));
}

void PlyContact::update_candidates(const Surface& surface, const SweptBounds& swept, std::span<const Vec3> x,
                                   double skin) {
    candidates_ = {};  // before others take room
    candidates_ = find_candidates(surface, swept, distances_.max_penetration() + skin);
    relative_motion_.rebuild(surface, candidates_, x);
    for (std::int32_t g = 0; g < relative_motion_.groups(); ++g)
        for (std::size_t k = 0; k < culling_states(g).size(); ++k) {
            auto& state = culling_states(g)[k];
            const auto f = relative_motion_.facets(g)[k];
            const auto candidates = candidates_.of(f);
            const auto ply = surface.facets[static_cast<std::size_t>(f)].ply;
            // Candidates have new slots, and through a hole a facet may meet what it was not known to be
            // clear of.
            const bool through_hole =
                !candidates.empty() &&
                surface.facets[static_cast<std::size_t>(candidates.back())].ply > ply + 1;
            if (state.culled != Culled::by_group || through_hole) state = {};
            state.first = -1;
            state.near = {};
            if (!surface.alive[static_cast<std::size_t>(f)]) memory_.forget(f);
        }
    std::ranges::fill(due_, 0);
}

double PlyContact::own_approach(std::int32_t f, const Shortlist& near, const Now& now) const {
    if (near.slots == 0) return 0;
    const auto box_of = [&](std::int32_t facet) {
        return NodeBox(now.v, now.surface.facets[static_cast<std::size_t>(facet)].nodes);
    };
    auto others = NodeBox::none();
    candidates_.of(f).visit_some(near.slots, [&](std::int32_t candidate) {
        others.add(box_of(candidate));
        return true;
    });
    return now.dt * std::sqrt(box_of(f).squared_difference(others));
}

bool PlyContact::expired(CullingState& state, std::int32_t f, double accumulated, const Now& now) const {
    if (state.culled != Culled::by_candidates) return accumulated >= state.until;
    if (accumulated >= state.near.until) return true;
    state.until = not_above(state.until - own_approach(f, state.near, now));
    return state.until <= 0;
}

void PlyContact::recheck(std::int32_t f, CullingState& state, std::int32_t group, const Now& now) {
    const auto& facet = now.surface.facets[static_cast<std::size_t>(f)];
    const auto corners = corners_of(facet.nodes, now.x);
    const auto candidates = candidates_.of(f);
    const auto rule = rules_[static_cast<std::size_t>(f)];
    const ContactPoints points(quadrature_.rule(rule), corners, quadrature_.spanned(rule, corners));
    const ClearanceQuery query{facet.ply, points, candidates, now.surface, distances_, now.x};
    const double accumulated = relative_motion_.accumulated(group),
                 worthwhile = worth_waiting_in_distance * distances_.most();
    const bool remembers = memory_.holds(f);  // as long as it does it is evaluated
    const double clear = remembers ? 0 : clearance(query, state.first, state.near, accumulated, worthwhile);
    if (clear > own_in_steps * relative_motion_.of_last_step(group)) {
        state.culled = Culled::by_group;
        state.until = not_above(accumulated + clear);
    } else if (clear > 0) {
        state.culled = Culled::by_candidates;
        state.until = not_above(clear);
    } else {
        state.culled = Culled::no;
    }
    const bool is_culled = state.culled != Culled::no;
    if (is_culled && state.first >= 0) return;
    const auto nearest = find_nearest(query, centre_of(corners));
    state.first = is_culled || nearest.lead > worthwhile ? nearest.facet : -1;
    if (is_culled) return;
    const double again = look_again_in_distance * distances_.most();
    const double known = remembers ? nearest.lead : std::min(nearest.lead, again);
    state.until = not_above(accumulated + (state.first < 0 ? again : known));
}

// A point takes what it meets first in the order of near facets. Nearly always that is the first of all
// candidates: the others are looked at where some point misses it.
void PlyContact::evaluate_facet(std::int32_t f, std::int32_t first, const Now& now, ContactForces& forces) {
    const auto& facet = now.surface.facets[static_cast<std::size_t>(f)];
    const auto& rule = quadrature_.rule(rules_[static_cast<std::size_t>(f)]);
    const auto corners = corners_of(facet.nodes, now.x);
    NormalRays rays(rule, corners, now.normals.of(facet, now.surface, now.x), distances_.max_penetration(),
                    distances_.most());
    const auto candidates = candidates_.of(f);
    bool complete = first < 0;
    targets_.start(facet, corners);
    const FacetRange only_first{first, 1};
    targets_.add(complete ? candidates : FacetRanges({&only_first, 1}), rays, now.surface, distances_, now.x);
    pair_of_.assign(targets_.size(), -1);
    auto& dissipated_budget = dissipated_budgets_[static_cast<std::size_t>(f)];
    Slave slave{.facet = f,
                .velocities = corners_of(facet.nodes, now.v),
                .points = memory_.recall(f),
                .around = {dissipated_budget, now.sliding_share}};
    for (std::size_t b = 0; b < rule.size(); ++b) {
        auto& points = slave.points[b];
        auto open = all_of(rule[b]);
        for (std::size_t k = 0; any(open); ++k) {
            if (k == targets_.size() && !complete) {
                targets_.add(candidates, rays, now.surface, distances_, now.x);
                pair_of_.resize(targets_.size(), -1);
                complete = true;
            }
            if (k == targets_.size()) break;
            press(slave, rule[b], rays.batches[b], points, k, open, now, forces);
        }
        for (std::size_t i = 0; i < batch_width; ++i)
            if (open[i]) points.overlap[i] = points.ignored[i] = points.opened[i] = 0;
    }
    dissipated_budget += slave.sum.dissipated;
    if (slave.sum.sliding.is_any())
        forces.sliding.push_back(slave.sum.sliding.times(now.surface.areas[static_cast<std::size_t>(f)]));
    if (slave.touching)
        memory_.keep(f, slave.points);
    else
        memory_.forget(f);
}

void PlyContact::press(Slave& slave, const QuadratureBatch& batch, const Rays& rays, PenetrationLanes& points,
                       std::size_t near, LaneMask& open, const Now& now, ContactForces& forces) {
    const auto& facet = now.surface.facets[static_cast<std::size_t>(slave.facet)];
    const auto& other = now.surface.facets[static_cast<std::size_t>(targets_[near])];
    const auto hits = intersect(rays, corners_of(other.nodes, now.x));
    const double reach = distances_.between(facet.ply, other.ply), depth = distances_.max_penetration();
    Lanes overlap;
    LaneMask met, matters;
    for (std::size_t i = 0; i < batch_width; ++i) {
        overlap[i] = reach - hits.distance[i];
        const bool meets = open[i] & hits.hit[i] & (hits.distance[i] >= -depth);
        open[i] = open[i] & !meets;
        // A point that is already beyond the other mid-surface when first seen went through a hole: it is not
        // pushed back.
        met[i] = meets & ((points.overlap[i] != 0) | (overlap[i] <= reach));
        matters[i] = met[i] & ((points.overlap[i] != 0) | (overlap[i] > 0));
    }
    if (!any(matters)) return;
    const auto N = shape_functions(hits);
    const auto motion = relative_motion(interpolate(slave.velocities, batch.N),
                                        interpolate(corners_of(other.nodes, now.v), N), rays.direction);
    const auto pressure =
        law(facet.ply, other.ply)
            .advance(points, met, overlap, motion, now.dt, batch.share, slave.around, slave.sum);
    const double area = now.surface.areas[static_cast<std::size_t>(slave.facet)];
    for (std::size_t i = 0; i < batch_width; ++i) {
        slave.touching = slave.touching || (met[i] && points.overlap[i] > 0);
        if (met[i] && overlap[i] > reach * forces.deepest.in_thicknesses)
            forces.deepest.include({overlap[i], overlap[i] / reach,
                                    Vec3(rays.origin.x[i], rays.origin.y[i], rays.origin.z[i]), facet.id});
        if (!(pressure[i] > 0)) continue;
        auto& pair = pair_of_[near];
        if (pair < 0) {
            pair = static_cast<std::int32_t>(forces.pairs.size());
            forces.pairs.emplace_back(facet.nodes, other.nodes);
        }
        const double size = -pressure[i] * area * batch.share[i];
        const Vec3 force(size * rays.direction.x[i], size * rays.direction.y[i], size * rays.direction.z[i]);
        forces.pairs[static_cast<std::size_t>(pair)].add(force, batch.N, N, i);
    }
}

void PlyContact::evaluate_group(std::int32_t g, const Now& now, ContactForces& forces) {
    const double accumulated = relative_motion_.accumulated(g);
    auto& due = due_[static_cast<std::size_t>(g)];
    if (accumulated < due) return;
    due = std::numeric_limits<double>::max();
    const auto of_group = culling_states(g);
    const auto facets = relative_motion_.facets(g);
    for (std::size_t k = 0; k < of_group.size(); ++k) {
        auto& state = of_group[k];
        const auto f = facets[k];
        if (!now.surface.alive[static_cast<std::size_t>(f)]) continue;
        if (expired(state, f, accumulated, now)) recheck(f, state, g, now);
        if (state.culled == Culled::no) {
            const bool remembered = memory_.holds(f);
            evaluate_facet(f, state.first, now, forces);
            if (remembered && !memory_.holds(f)) state.until = 0;  // it may be clear from now on
        }
        due =
            std::min(due, state.culled == Culled::by_group ? static_cast<double>(state.until) : accumulated);
    }
}

void PlyContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                          std::span<const Vec3> v, double dt, double sliding_share, ContactForces& forces) {
    relative_motion_.advance(v, dt);
    for (std::int32_t g = 0; g < relative_motion_.groups(); ++g)
        evaluate_group(g, {surface, normals, x, v, dt, sliding_share}, forces);
}

std::vector<std::int32_t> PlyContact::behind_next_ply(const Surface& surface, std::span<const Vec3> x) const {
    const auto counts = [&](std::int32_t f) {
        const auto i = static_cast<std::size_t>(f);
        return surface.alive[i] && (surface.on_free_edge.empty() || !surface.on_free_edge[i]);
    };
    std::vector<std::int32_t> behind;
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        if (!counts(f)) continue;
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        const auto corners = corners_of(facet.nodes, x);
        const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
        const auto ray = one_ray(centre_of(corners), normal);
        for (const auto other : candidates_.of(f)) {
            const auto& of_next = surface.facets[static_cast<std::size_t>(other)];
            if (of_next.ply != facet.ply + 1 || !counts(other)) continue;
            const auto hits = intersect(ray, corners_of(of_next.nodes, x));
            if (!hits.hit[0] || hits.distance[0] > -distances_.between(facet.ply, of_next.ply)) continue;
            behind.push_back(f);
            break;
        }
    }
    return behind;
}

}  // namespace weavefront::contact
