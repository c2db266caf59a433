#include "weavefront/contact/projectile_contact.hpp"

#include "weavefront/contact/rigid_pressure.hpp"

namespace weavefront::contact {

ProjectileContact::ProjectileContact(const scene::Projectile& projectile, const scene::ContactLaw& law, std::optional<double> spacing,
                                     const Surface& surface, std::span<const Vec3> x)
    : quadrature_(spacing), points_(static_cast<std::size_t>(surface.owned)), reserves_(points_.size()) {
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

void ProjectileContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x, std::span<const Vec3> v,
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
        RigidPair pair{facet,
                       surface.areas[index],
                       quadrature_.rule(rules_[index]),
                       laws_[static_cast<std::size_t>(facet.ply)],
                       Master::projectile,
                       projectile.velocity};
        if (!quadrature_.at_nodes()) pair.normals = normals.of(facet, surface, x);
        const auto force = press(pair, x, v, dt, points_[index], reserves_[index],
                                 [&](const Vec3& at, Point& point) { return shape.depth(at - projectile.position, point.side); });
        if (force.total != Vec3::Zero()) forces.push_back(force);
    }
}

void ProjectileContact::save(std::int32_t facet, std::vector<double>& record) const {
    const auto f = static_cast<std::size_t>(facet);
    save_points(reserves_[f], points_[f], record);
    for (const auto& point : points_[f]) record.push_back(static_cast<double>(point.side));
}

std::span<const double> ProjectileContact::restore(std::int32_t facet, std::span<const double> record) {
    const auto f = static_cast<std::size_t>(facet);
    auto rest = restore_points(reserves_[f], points_[f], record);
    for (auto& point : points_[f]) {
        point.side = static_cast<Side>(rest.front());
        rest = rest.subspan(1);
    }
    return rest;
}

}  // namespace weavefront::contact
