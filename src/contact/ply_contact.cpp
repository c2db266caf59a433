#include "weavefront/contact/ply_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::contact {

namespace {

// Pressures of a few GPa press two plies into each other by about their thickness; a point deeper than this has gone through a hole.
constexpr double deepest_in_thicknesses = 4;

// Both sides of a gap between plies are bilinear over an element, with edges of the other ply's elements in between: more points than this
// along an edge resolve nothing. (The projectile's edge is finer than any element; its contact knows no such bound.)
constexpr int most_points = 4;
constexpr std::size_t most_batches = (most_points * most_points + batch_width - 1) / batch_width;

/// Lines through the points of a batch along the smoothed normals.
Rays rays_of(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& normals, const QuadratureBatch& points) {
    Rays rays{interpolate(corners, points.N), interpolate(normals, points.N)};
    auto& n = rays.direction;
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double length = std::sqrt(n.x[i] * n.x[i] + n.y[i] * n.y[i] + n.z[i] * n.z[i]);
        const double inverse = length > 0 ? 1 / length : 0;
        n.x[i] *= inverse;
        n.y[i] *= inverse;
        n.z[i] *= inverse;
    }
    return rays;
}

/// Box around the stretches of lines on which something may be met.
/// @param back, ahead how far they go against and along their direction, m
void widen(Box& box, const Rays& rays, double back, double ahead) {
    const auto stretch = [&](const Lanes& origin, const Lanes& direction, double& low, double& high) {
        for (std::size_t i = 0; i < batch_width; ++i) {
            const double behind = origin[i] - back * direction[i], before = origin[i] + ahead * direction[i];
            const double lower = behind < before ? behind : before, upper = behind < before ? before : behind;
            low = lower < low ? lower : low;
            high = upper > high ? upper : high;
        }
    };
    stretch(rays.origin.x, rays.direction.x, box.low.x(), box.high.x());
    stretch(rays.origin.y, rays.direction.y, box.low.y(), box.high.y());
    stretch(rays.origin.z, rays.direction.z, box.low.z(), box.high.z());
}

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

/// Rates at which the points approach what their lines meet.
Lanes closing_rates(const VectorLanes& slave, const VectorLanes& master, const VectorLanes& direction) {
    Lanes rates;
    for (std::size_t i = 0; i < batch_width; ++i)
        rates[i] = (slave.x[i] - master.x[i]) * direction.x[i] + (slave.y[i] - master.y[i]) * direction.y[i] +
                   (slave.z[i] - master.z[i]) * direction.z[i];
    return rates;
}

}  // namespace

PlyContact::PlyContact(const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface, std::span<const Vec3> x)
    : plies_(surface.plies),
      quadrature_(spacing, most_points),
      points_(static_cast<std::size_t>(surface.owned)),
      reserves_(points_.size()) {
    for (const auto& ply : plies_) {
        most_touching_ = std::max(most_touching_, ply.thickness);
        depth_ = std::max(depth_, depth(ply.thickness));
        for (const auto& other : plies_)
            laws_.emplace_back(law, ply.areal_density * other.areal_density / (ply.areal_density + other.areal_density));
    }
    for (std::size_t f = 0; f < points_.size(); ++f) rules_.push_back(quadrature_.rule_for(corners_of(surface.facets[f].nodes, x)));
}

double PlyContact::depth(double thickness) { return deepest_in_thicknesses * thickness; }

void PlyContact::update_candidates(const Surface& surface, std::span<const Vec3> x, double skin) {
    candidates_ = find_candidates(surface, x, depth_ + skin);
    normals_.rebuild(surface, x.size());
    for (std::size_t f = 0; f < points_.size(); ++f)
        if (!surface.alive[f]) points_[f] = {};
}

double PlyContact::touching_distance(std::int32_t ply, std::int32_t other) const {
    const auto &a = plies_[static_cast<std::size_t>(ply)], &b = plies_[static_cast<std::size_t>(other)];
    // Plies that lie closer than their thickness at the start touch there without pressing.
    return std::min((a.thickness + b.thickness) / 2, b.z - a.z);
}

/// One facet whose points look for what they touch.
struct PlyContact::Slave {
    std::int32_t facet;
    const QuadratureRule& rule;
    std::array<Vec3, 4> corners, velocities{};
    std::array<Rays, most_batches> rays{};
    Box stretch;  // around all that the lines may meet
    bool touching = false;
};

PlyContact::Slave PlyContact::lines_of(std::int32_t f, const Surface& surface, std::span<const Vec3> x) {
    const auto& nodes = surface.facets[static_cast<std::size_t>(f)].nodes;
    constexpr double far = std::numeric_limits<double>::max();
    Slave slave{.facet = f,
                .rule = quadrature_.rule(rules_[static_cast<std::size_t>(f)]),
                .corners = corners_of(nodes, x),
                .stretch = {Vec3::Constant(far), Vec3::Constant(-far)}};
    std::array<Vec3, 4> normals;
    for (std::size_t a = 0; a < 4; ++a) normals[a] = normals_.at(nodes[a], surface, x);
    for (std::size_t b = 0; b < slave.rule.size(); ++b) {
        slave.rays[b] = rays_of(slave.corners, normals, slave.rule[b]);
        widen(slave.stretch, slave.rays[b], depth_, most_touching_);
    }
    return slave;
}

void PlyContact::find_reachable(const Surface& surface, std::int32_t f) {
    reachable_.clear();
    const double highest = boxes_.z_high[static_cast<std::size_t>(f)] + most_touching_;
    for (const auto other : candidates_.of(f)) {
        const auto o = static_cast<std::size_t>(other);
        if (boxes_.z_low[o] <= highest && surface.alive[o]) reachable_.push_back(other);
    }
}

void PlyContact::find_near(const Slave& slave, const Surface& surface, std::span<const Vec3> x) {
    near_.clear();
    const auto ply = surface.facets[static_cast<std::size_t>(slave.facet)].ply;
    const auto& corners = slave.corners;
    const Vec3 centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
    double front = 0;
    for (const auto& corner : corners) front = std::max(front, (corner - centre).dot(normal));
    for (const auto other : reachable_) {
        const auto o = static_cast<std::size_t>(other);
        if (!boxes_.meet(o, slave.stretch)) continue;
        // Seen along the normal of this facet the other must not lie wholly ahead of its foremost corner; a line at a slant only meets it
        // later.
        const auto other_ply = surface.facets[o].ply;
        const auto others = corners_of(surface.facets[o].nodes, x);
        double nearest = (others[0] - centre).dot(normal);
        for (std::size_t c = 1; c < 4; ++c) nearest = std::min(nearest, (others[c] - centre).dot(normal));
        if (nearest > front + touching_distance(ply, other_ply)) continue;
        near_.push_back({other, other_ply, ((others[0] + others[1] + others[2] + others[3]) / 4 - centre).squaredNorm()});
    }
    std::ranges::stable_sort(near_, [](const Near& l, const Near& r) { return l.ply != r.ply ? l.ply < r.ply : l.apart < r.apart; });
}

void PlyContact::press(Slave& slave, const QuadratureBatch& points, const Rays& rays, std::size_t near, const Surface& surface,
                       std::span<const Vec3> x, std::span<const Vec3> v, double dt, OpenPoints& open, Batch& batch,
                       std::vector<PairForce>& forces) {
    const auto& facet = surface.facets[static_cast<std::size_t>(slave.facet)];
    const auto& other = surface.facets[static_cast<std::size_t>(near_[near].facet)];
    const auto hits = meet(rays, corners_of(other.nodes, x));
    const auto N = shape_functions(hits);
    const auto closing = closing_rates(interpolate(slave.velocities, points.N), interpolate(corners_of(other.nodes, v), N), rays.direction);
    const double reach = touching_distance(facet.ply, other.ply);
    const auto& penalty = law(facet.ply, other.ply);
    for (std::size_t i = 0; i < batch_width; ++i) {
        if (!open.lane[i] || !hits.hit[i] || hits.distance[i] < -depth_) continue;
        open.lane[i] = false;
        --open.count;
        auto& point = batch.point[i];
        const double overlap = reach - hits.distance[i];
        // A point that is already beyond the other mid-surface when first seen went through a hole: it is not pushed back.
        if (point.present == 0 && overlap > reach) continue;
        const double pressure =
            penalty.advance(point, overlap, closing[i], dt, points.share[i], reserves_[static_cast<std::size_t>(slave.facet)]);
        slave.touching = slave.touching || point.present > 0;
        if (!(pressure > 0)) continue;
        auto& pair = pair_of_[near];
        if (pair < 0) {
            pair = static_cast<std::int32_t>(forces.size());
            forces.emplace_back(facet.nodes, other.nodes);
        }
        const double size = -pressure * surface.areas[static_cast<std::size_t>(slave.facet)] * points.share[i];
        const Vec3 force(size * rays.direction.x[i], size * rays.direction.y[i], size * rays.direction.z[i]);
        forces[static_cast<std::size_t>(pair)].add(force, points.N, N, i);
    }
}

bool PlyContact::evaluate_facet(std::int32_t f, const Surface& surface, std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                                std::vector<PairForce>& forces) {
    auto slave = lines_of(f, surface, x);
    find_near(slave, surface, x);
    if (near_.empty()) return false;
    slave.velocities = corners_of(surface.facets[static_cast<std::size_t>(f)].nodes, v);
    auto& points = points_[static_cast<std::size_t>(f)];
    std::array<Batch, most_batches> batches{};
    std::ranges::copy(points, batches.begin());
    pair_of_.assign(near_.size(), -1);
    for (std::size_t b = 0; b < slave.rule.size(); ++b) {
        OpenPoints open{{}, slave.rule[b].count};
        std::fill_n(open.lane.begin(), open.count, true);
        for (std::size_t k = 0; k < near_.size() && open.count > 0; ++k)
            press(slave, slave.rule[b], slave.rays[b], k, surface, x, v, dt, open, batches[b], forces);
        for (std::size_t i = 0; i < batch_width; ++i)
            if (open.lane[i]) batches[b].point[i] = {};
    }
    if (slave.touching) points.assign(batches.begin(), batches.begin() + static_cast<std::ptrdiff_t>(slave.rule.size()));
    return slave.touching;
}

void PlyContact::evaluate(const Surface& surface, std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                          std::vector<PairForce>& forces) {
    normals_.new_positions();
    boxes_.update(surface, x);
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        if (!surface.alive[static_cast<std::size_t>(f)]) continue;
        find_reachable(surface, f);
        if (reachable_.empty() || !evaluate_facet(f, surface, x, v, dt, forces)) points_[static_cast<std::size_t>(f)].clear();
    }
}

void PlyContact::save(std::int32_t facet, std::vector<double>& record) const {
    const auto f = static_cast<std::size_t>(facet);
    record.insert(record.end(), {reserves_[f], static_cast<double>(points_[f].size())});
    for (const auto& batch : points_[f])
        for (const auto& point : batch.point) record.insert(record.end(), {point.present, point.largest});
}

std::span<const double> PlyContact::restore(std::int32_t facet, std::span<const double> record) {
    const auto f = static_cast<std::size_t>(facet);
    auto next = record.begin();
    reserves_[f] = *next++;
    points_[f].resize(static_cast<std::size_t>(*next++));
    for (auto& batch : points_[f])
        for (auto& point : batch.point) {
            point.present = *next++;
            point.largest = *next++;
        }
    return {next, record.end()};
}

}  // namespace weavefront::contact
