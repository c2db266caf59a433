#include "weavefront/contact/projectile_contact.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

ProjectileContact::ProjectileContact(const scene::Projectile& projectile, const scene::ContactLaw& law, std::optional<double> spacing,
                                     const Surface& surface, std::span<const Vec3> x)
    : quadrature_(spacing), rules_(rules_for(quadrature_, surface, x)), memories_(surface.owned) {
    for (const auto& ply : surface.plies) {
        shapes_.emplace_back(projectile, ply.thickness / 2);
        laws_.emplace_back(law, ply.areal_density);  // damps as if the projectile stood still
    }
}

void ProjectileContact::update_candidates(const Surface& surface, const Whereabouts& expected, const Footprint& way, double skin) {
    candidates_.clear();
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        if (!surface.alive[static_cast<std::size_t>(f)]) {
            memories_.forget(f);
            continue;
        }
        if (way.near(expected.of(facet), shapes_[static_cast<std::size_t>(facet.ply)].radius() + skin)) candidates_.push_back(f);
    }
}

void ProjectileContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x, std::span<const Vec3> v,
                                 const ProjectileState& projectile, double dt, std::vector<PairForce>& forces) {
    for (const auto f : candidates_) {
        const auto index = static_cast<std::size_t>(f);
        if (!surface.alive[index]) continue;
        const auto& facet = surface.facets[index];
        const auto& shape = shapes_[static_cast<std::size_t>(facet.ply)];
        const auto box = Box::around(facet, x);
        // Near enough for the side on which a point comes in to be noted before it does; before the first step nothing is known of the way.
        double fastest = 0;
        for (const auto node : facet.nodes)
            fastest = std::max(fastest, (v[static_cast<std::size_t>(node)] - projectile.velocity).squaredNorm());
        const double margin = dt > 0 ? 0.01 * shape.radius() + 4 * dt * std::sqrt(fastest) : shape.radius();
        const double z = projectile.position.z();
        const auto apart = [&](int d) {
            const double reach = shape.radius() + margin;
            return box.low[d] > projectile.position[d] + reach || box.high[d] < projectile.position[d] - reach;
        };
        if (apart(0) || apart(1) || box.low.z() > z + shape.front() + margin || box.high.z() < z + shape.rear() - margin) {
            forget_points(memories_, f);
            continue;
        }
        const RigidPair pair{facet,
                             surface.areas[index],
                             quadrature_.rule(rules_[index]),
                             laws_[static_cast<std::size_t>(facet.ply)],
                             Master::projectile,
                             projectile.velocity};
        const auto depth = [&](const Vec3& at, Point& point) { return shape.depth(at - projectile.position, point.side); };
        const auto of_ply = [&] { return quadrature_.at_nodes() ? PlyNormals() : normals.of(facet, surface, x); };
        const auto force = press(pair, x, v, dt, memories_.take(f), depth, of_ply);
        if (force.total != Vec3::Zero()) forces.push_back(force);
    }
}

void ProjectileContact::save(std::int32_t facet, std::vector<double>& record) const {
    const auto* memory = memories_.find(facet);
    const RigidMemory<Point> none;
    const auto& saved = memory ? *memory : none;
    save_points(saved, record);
    for (const auto& point : saved.points) record.push_back(static_cast<double>(point.side));
}

std::span<const double> ProjectileContact::restore(std::int32_t facet, std::span<const double> record) {
    RigidMemory<Point> memory;
    auto rest = restore_points(memory, record);
    for (auto& point : memory.points) {
        point.side = static_cast<Side>(rest.front());
        rest = rest.subspan(1);
    }
    keep(memories_, facet, std::move(memory));
    return rest;
}

}  // namespace weavefront::contact
