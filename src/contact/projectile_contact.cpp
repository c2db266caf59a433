#include "weavefront/contact/projectile_contact.hpp"

namespace weavefront::contact {

ProjectileContact::ProjectileContact(const scene::Projectile& projectile, const scene::ContactLaw& law, std::optional<double> spacing,
                                     const Surface& surface, std::span<const Vec3> x)
    : quadrature_(spacing), points_(static_cast<std::size_t>(surface.owned)) {
    for (const auto& ply : surface.plies) {
        shapes_.emplace_back(projectile, ply.thickness / 2);
        laws_.emplace_back(law, ply.areal_density);  // the projectile is far heavier than the fabric under one point
    }
    for (std::size_t f = 0; f < points_.size(); ++f) rules_.push_back(quadrature_.rule_for(corners_of(surface.facets[f].nodes, x)));
}

void ProjectileContact::update_candidates(const Surface& surface, std::span<const Vec3> x, const ProjectileState& projectile, double skin) {
    candidates_.clear();
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        if (!surface.alive[static_cast<std::size_t>(f)]) continue;
        const auto box = Box::around(facet, x);
        const double reach = shapes_[static_cast<std::size_t>(facet.ply)].radius() + skin;
        const auto apart = [&](int d) {
            return box.low[d] > projectile.position[d] + reach || box.high[d] < projectile.position[d] - reach;
        };
        if (!apart(0) && !apart(1)) candidates_.push_back(f);
    }
    for (std::size_t f = 0; f < points_.size(); ++f)
        if (!surface.alive[f]) points_[f] = {};
}

void ProjectileContact::evaluate(const Surface& surface, std::span<const Vec3> x, std::span<const Vec3> v,
                                 const ProjectileState& projectile, double dt, std::vector<PairForce>& forces) {
    for (const auto f : candidates_) {
        const auto index = static_cast<std::size_t>(f);
        if (!surface.alive[index]) continue;
        const auto& facet = surface.facets[index];
        const auto& shape = shapes_[static_cast<std::size_t>(facet.ply)];
        const auto box = Box::around(facet, x);
        // Near enough for the side on which a point comes in to be noted before it does: a tenth of the radius is many steps.
        const double margin = 0.1 * shape.radius();
        const double z = projectile.position.z();
        const auto apart = [&](int d) {
            const double reach = shape.radius() + margin;
            return box.low[d] > projectile.position[d] + reach || box.high[d] < projectile.position[d] - reach;
        };
        if (apart(0) || apart(1) || box.low.z() > z + shape.front() + margin || box.high.z() < z + shape.rear() - margin) {
            points_[index] = {};
            continue;
        }
        const auto& rule = quadrature_.rule(rules_[index]);
        auto& points = points_[index];
        if (points.empty()) points.resize(rule.size() * batch_width);
        const auto force = force_on(facet, surface.areas[index], x, v, projectile, dt, rule, points);
        if (force.total != Vec3::Zero()) forces.push_back(force);
    }
}

PairForce ProjectileContact::force_on(const Facet& facet, double area, std::span<const Vec3> x, std::span<const Vec3> v,
                                      const ProjectileState& projectile, double dt, const QuadratureRule& rule,
                                      std::vector<Point>& points) const {
    const auto& shape = shapes_[static_cast<std::size_t>(facet.ply)];
    const auto& law = laws_[static_cast<std::size_t>(facet.ply)];
    const auto corners = corners_of(facet.nodes, x), velocities = corners_of(facet.nodes, v);
    PairForce sum(facet.nodes);
    for (std::size_t b = 0; b < rule.size(); ++b) {
        const auto position = interpolate(corners, rule[b].N), velocity = interpolate(velocities, rule[b].N);
        for (std::size_t i = 0; i < rule[b].count; ++i) {
            auto& point = points[b * batch_width + i];
            const Vec3 at(position.x[i], position.y[i], position.z[i]), moving(velocity.x[i], velocity.y[i], velocity.z[i]);
            const auto found = shape.depth(at - projectile.position, point.side);
            if (!found) {
                point.penetration = {};
                continue;
            }
            const double closing = (projectile.velocity - moving).dot(found->normal);
            const double pressure = law.advance(point.penetration, found->depth, closing, dt);
            sum.add(pressure * area * rule[b].share[i] * found->normal, rule[b].N, i);
        }
    }
    return sum;
}

}  // namespace weavefront::contact
