#include "weavefront/contact/projectile_contact.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

namespace {

/// Whether no point of a box is within a margin of the projectile.
bool is_apart(const ProjectileShape& shape, const ProjectileState& projectile, const Box& box,
              double margin) {
    const Vec3 low(-shape.radius(), -shape.radius(), shape.rear()),
        high(shape.radius(), shape.radius(), shape.front());
    const Box around{projectile.position + low - Vec3::Constant(margin),
                     projectile.position + high + Vec3::Constant(margin)};
    return !box.meets(around);
}

}  // namespace

ProjectileContact::ProjectileContact(const scene::Projectile& projectile, const scene::ContactLaw& law,
                                     std::optional<double> spacing, const Surface& surface,
                                     std::span<const Vec3> x)
    : quadrature_(spacing, surface, x), memories_(surface.owned) {
    for (const auto& ply : surface.plies) {
        shapes_.emplace_back(projectile, ply.thickness / 2);
        laws_.emplace_back(law, ply.areal_density);  // damping takes the projectile for infinitely heavy
    }
}

void ProjectileContact::update_candidates(const Surface& surface, const SweptBounds& swept,
                                          const Footprint& way, double skin) {
    candidates_.clear();
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        if (!surface.alive[static_cast<std::size_t>(f)]) {
            memories_.forget(f);
            continue;
        }
        if (way.near(swept.of(facet), shapes_[static_cast<std::size_t>(facet.ply)].radius() + skin))
            candidates_.push_back(f);
    }
}

void ProjectileContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                                 std::span<const Vec3> v, const ProjectileState& projectile, double dt,
                                 double sliding_share, ContactForces& forces) {
    for (const auto f : candidates_) {
        const auto index = static_cast<std::size_t>(f);
        if (!surface.alive[index]) continue;
        const auto& facet = surface.facets[index];
        const auto ply = static_cast<std::size_t>(facet.ply);
        const auto& shape = shapes_[ply];
        const auto box = Box::around(facet, x);
        const Vec3 middle = projectile.position + Vec3(0, 0, (shape.front() + shape.rear()) / 2);
        const RigidPair pair{.facet = facet,
                             .area = surface.areas[index],
                             .rule = quadrature_.rule(f),
                             .law = laws_[ply],
                             .thickness = surface.plies[ply].thickness,
                             .body = Master::projectile,
                             .away = (box.low + box.high) / 2 - middle,
                             .body_velocity = projectile.velocity};
        // Points within the margin note their side before they enter the projectile. Before the first step
        // their velocities are not known.
        double fastest = 0;
        for (const auto node : facet.nodes)
            fastest =
                std::max(fastest, (v[static_cast<std::size_t>(node)] - projectile.velocity).squaredNorm());
        const double margin = dt > 0 ? 0.01 * shape.radius() + 4 * dt * std::sqrt(fastest) : shape.radius();
        if (is_apart(shape, projectile, box, margin)) {
            forget_points(memories_, f);
            continue;
        }
        const auto depth = [&](const Vec3& at, Point& point) {
            return shape.depth(at - projectile.position, point.side);
        };
        const auto of_ply = [&] {
            return quadrature_.at_nodes() ? PlyNormals() : normals.of(facet, surface, x);
        };
        press(pair, {x, v, dt}, sliding_share, memories_.take(f), depth, of_ply, forces);
    }
}

}  // namespace weavefront::contact
