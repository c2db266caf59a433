#include "weavefront/contact/ply_contact.hpp"

#include <algorithm>
#include <cmath>

#include "weavefront/contact/bilinear_quad.hpp"
#include "weavefront/contact/facets_behind.hpp"

namespace weavefront::contact {

namespace {

/// Overlaps of a batch of points with one target.
struct Overlaps {
    Lanes overlap;       ///< m; negative: apart
    LaneMask met;        ///< points whose master is the target
    LaneMask needs_law;  ///< those of them that overlap now or did in the last step
};

/// @param unassigned points without a master; those that meet the target leave the mask
/// @param contact_distance m
/// @param depth  points deeper than this behind the target do not meet it, m
Overlaps overlaps_of(const RayHits& hits, const PenetrationLanes& points, double contact_distance,
                     double depth, LaneMask& unassigned) {
    Overlaps result;
    auto& [overlap, met, needs_law] = result;
    for (std::size_t i = 0; i < batch_width; ++i) {
        overlap[i] = contact_distance - hits.distance[i];
        const bool was_unassigned = unassigned[i], hits_target = hits.hit[i],
                   is_in_front = hits.distance[i] >= -depth;
        const bool overlapped = points.overlap[i] != 0, overlaps = overlap[i] > 0;
        const bool meets = was_unassigned & hits_target & is_in_front;
        unassigned[i] = was_unassigned & !meets;
        // A point that is first seen behind the mid-surface of its master went through a hole. It is not
        // pushed back.
        const bool is_before_surface = overlap[i] <= contact_distance;
        const bool is_met = meets & (overlapped | is_before_surface);
        met[i] = is_met;
        needs_law[i] = is_met & (overlapped | overlaps);
    }
    return result;
}

// A distance along a ray changes by at most this times the relative motion of the two sides where the ray
// meets the facet at up to 60 deg. At a larger angle the rest of the change counts as a jump, which does not
// press.
constexpr double stretch_along_ray = 2;

/// Relative motion of the points towards their masters. @param slave, master velocities, m/s
RelativeMotionLanes relative_motion(const VectorLanes& slave, const VectorLanes& master,
                                    const VectorLanes& direction) {
    RelativeMotionLanes motion;
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double x = slave.x[i] - master.x[i], y = slave.y[i] - master.y[i], z = slave.z[i] - master.z[i];
        motion.closing[i] = x * direction.x[i] + y * direction.y[i] + z * direction.z[i];
        motion.most[i] = stretch_along_ray * std::sqrt(x * x + y * y + z * z);
    }
    return motion;
}

/// The points of a batch, without its padding.
LaneMask points_of(const QuadratureBatch& batch) {
    LaneMask mask{};
    std::fill_n(mask.begin(), batch.count, true);
    return mask;
}

Vec3 vector_at(const VectorLanes& lanes, std::size_t i) { return {lanes.x[i], lanes.y[i], lanes.z[i]}; }

}  // namespace

PlyContact::PlyContact(const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface,
                       std::span<const Vec3> x)
    : distances_(surface.plies),
      laws_(law, surface.plies),
      friction_(CoulombLaw::of(law)),
      quadrature_(spacing, surface, x, most_points_along_edge),
      culling_(surface, x),
      memory_(static_cast<std::size_t>(surface.owned), friction_.has_value()) {}

void PlyContact::update_candidates(const Surface& surface, const SweptBounds& swept, std::span<const Vec3> x,
                                   double skin) {
    candidates_ = {};  // frees the old list before the new one takes memory
    candidates_ = find_candidates(surface, swept, distances_.max_penetration() + skin);
    culling_.rebuild(surface, candidates_, x);
    for (std::int32_t f = 0; f < surface.owned; ++f)
        if (!surface.alive[static_cast<std::size_t>(f)]) memory_.forget(f);
}

void PlyContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                          std::span<const Vec3> v, double dt, double sliding_share, ContactForces& forces) {
    const Step step{surface, normals, {x, v, dt}, sliding_share};
    culling_.for_each_active(
        {surface, candidates_, distances_, quadrature_, memory_, step.nodes},
        [&](std::int32_t facet, std::int32_t nearest) { evaluate_facet(facet, nearest, step, forces); });
}

void PlyContact::evaluate_facet(std::int32_t f, std::int32_t nearest, const Step& step,
                                ContactForces& forces) {
    const auto& surface = step.surface;
    const auto& facet = surface.facets[static_cast<std::size_t>(f)];
    const auto& rule = quadrature_.rule(f);
    RaySearch search(
        targets_,
        {facet, rule, corners_of(facet.nodes, step.nodes.x), step.normals.of(facet, surface, step.nodes.x)},
        candidates_.of(f), nearest, surface, distances_, step.nodes.x);
    pairs_.start();
    auto& dissipated_budget = memory_.dissipated_budget(f);
    Slave slave{.facet = facet,
                .area = surface.areas[static_cast<std::size_t>(f)],
                .velocities = corners_of(facet.nodes, step.nodes.v),
                .points = memory_.recall(f),
                .around = {dissipated_budget, step.sliding_share}};
    if (friction_) {
        friction_pairs_.start();
        slave.tractions = &memory_.tractions(f);
        slave.turn = turn_of(corners_of(facet.nodes, step.nodes.x), slave.velocities, step.nodes.dt);
    }
    for (std::size_t b = 0; b < rule.size(); ++b) {
        Batch batch{rule[b], search.rays(b), slave.points[b], points_of(rule[b]), b};
        for (std::size_t k = 0; any(batch.unassigned); ++k) {
            const auto target = search.target(k);
            if (!target) break;
            press_batch(slave, batch, k, surface.facets[static_cast<std::size_t>(*target)], step, forces);
        }
        // Points without a master lose their penetration.
        auto& points = batch.points;
        for (std::size_t i = 0; i < batch_width; ++i)
            if (batch.unassigned[i]) points.overlap[i] = points.ignored[i] = points.opened[i] = 0;
        if (friction_)
            for (std::size_t i = 0; i < batch_width; ++i)
                if (batch.unassigned[i]) (*slave.tractions)[b][i] = {};
    }
    dissipated_budget += slave.sum.dissipated;
    if (slave.sum.sliding.is_any()) forces.sliding.push_back(slave.sum.sliding.times(slave.area));
    if (slave.in_contact)
        memory_.keep(f, slave.points);
    else
        memory_.forget(f);
}

void PlyContact::press_batch(Slave& slave, Batch& batch, std::size_t target, const Facet& master,
                             const Step& step, ContactForces& forces) {
    const auto& facet = slave.facet;
    const auto& quadrature = batch.quadrature;
    const auto& rays = batch.rays;
    const double contact_distance = distances_.between(facet.ply, master.ply);
    const auto hits = intersect(rays, corners_of(master.nodes, step.nodes.x));
    const auto [overlap, met, needs_law] =
        overlaps_of(hits, batch.points, contact_distance, distances_.max_penetration(), batch.unassigned);
    if (!any(needs_law)) return;
    const auto N = shape_functions(hits.xi, hits.eta);
    const auto motion =
        relative_motion(interpolate(slave.velocities, quadrature.N),
                        interpolate(corners_of(master.nodes, step.nodes.v), N), rays.direction);
    const auto& law = laws_.between(facet.ply, master.ply);
    const auto pressure = law.advance(batch.points, met, overlap, motion, step.nodes.dt, quadrature.share,
                                      slave.around, slave.sum);
    PairForce* pair = nullptr;
    for (std::size_t i = 0; i < batch_width; ++i) {
        slave.in_contact = slave.in_contact || (met[i] && batch.points.overlap[i] > 0);
        if (met[i] && overlap[i] > contact_distance * forces.deepest.in_thicknesses)
            forces.deepest.include(
                {overlap[i], overlap[i] / contact_distance, vector_at(rays.origin, i), facet.id});
        if (!(pressure[i] > 0)) continue;
        if (!pair) pair = &pairs_.of(target, facet, master, forces.pairs);
        const double size = -pressure[i] * slave.area * quadrature.share[i];
        const Vec3 force(size * rays.direction.x[i], size * rays.direction.y[i], size * rays.direction.z[i]);
        pair->add(force, quadrature.N, N, i);
    }
    if (friction_) add_friction(slave, batch, target, master, {met, pressure, N}, step, forces);
}

void PlyContact::add_friction(Slave& slave, const Batch& batch, std::size_t target, const Facet& master,
                              const Met& met, const Step& step, ContactForces& forces) {
    const auto master_velocities = corners_of(master.nodes, step.nodes.v);
    PairForce* pair = nullptr;
    for (std::size_t i = 0; i < batch_width; ++i) {
        if (!met.points[i]) continue;
        const Vec3 slip = step.nodes.dt * (at_point(master_velocities, met.N, i) -
                                           at_point(slave.velocities, batch.quadrature.N, i));
        const Vec3& traction =
            friction_->advance((*slave.tractions)[batch.index][i], vector_at(batch.rays.direction, i),
                               met.pressure[i], {slip, slave.turn});
        if (traction == Vec3::Zero()) continue;
        if (!pair) pair = &friction_pairs_.of(target, slave.facet, master, forces.friction);
        pair->add(slave.area * batch.quadrature.share[i] * traction, batch.quadrature.N, met.N, i);
    }
}

double PlyContact::penetration(const Surface& surface, std::int32_t facet) const {
    const double most = memory_.largest(facet);
    const auto ply = surface.facets[static_cast<std::size_t>(facet)].ply;
    return most > 0 ? most / distances_.between(ply, ply + 1) : 0;
}

std::vector<std::int32_t> PlyContact::behind_next_ply(const Surface& surface, std::span<const Vec3> x) const {
    return facets_behind_next_ply(surface, candidates_, distances_, x);
}

}  // namespace weavefront::contact
