#include "weavefront/contact/projectile_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weavefront::contact {

namespace {

/// Whether no point of a box is within a margin of the inflated projectile.
bool is_apart(const body::Bounds& bounds, double offset, const ProjectileState& projectile, const Box& box,
              double margin) {
    const Vec3 low = bounds.low - Vec3::Constant(offset), high = bounds.high + Vec3::Constant(offset);
    const Box around{projectile.position + low - Vec3::Constant(margin),
                     projectile.position + high + Vec3::Constant(margin)};
    return !box.meets(around);
}

}  // namespace

ProjectileContact::ProjectileContact(std::shared_ptr<const body::Shape> shape, const scene::ContactLaw& law,
                                     std::optional<double> spacing, const Surface& surface,
                                     std::span<const Vec3> x)
    : shape_(std::move(shape)),
      bounds_(shape_->bounds()),
      radius_(shape_->radius()),
      quadrature_(spacing, surface, x),
      memories_(surface.owned) {
    for (const auto& ply : surface.plies)
        plies_.push_back(
            {ply.thickness / 2,
             PenaltyLaw(law, ply.areal_density)});  // damping takes the projectile for infinitely heavy
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
        if (way.near(swept.of(facet), radius_ + plies_[static_cast<std::size_t>(facet.ply)].offset + skin))
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
        const auto& [offset, law] = plies_[ply];
        const double radius = radius_ + offset;
        const auto box = Box::around(facet, x);
        const Vec3 middle =
            projectile.position + Vec3(0, 0, ((bounds_.high.z() + offset) + (bounds_.low.z() - offset)) / 2);
        const RigidPair pair{.facet = facet,
                             .area = surface.areas[index],
                             .rule = quadrature_.rule(f),
                             .law = law,
                             .thickness = surface.plies[ply].thickness,
                             .body = Master::projectile,
                             .away = (box.low + box.high) / 2 - middle,
                             .body_velocity = projectile.velocity};
        // Points within the margin note their face before they enter the projectile. Before the first step
        // their velocities are not known.
        double fastest = 0;
        for (const auto node : facet.nodes)
            fastest =
                std::max(fastest, (v[static_cast<std::size_t>(node)] - projectile.velocity).squaredNorm());
        const double margin = dt > 0 ? 0.01 * radius + 4 * dt * std::sqrt(fastest) : radius;
        if (is_apart(bounds_, offset, projectile, box, margin)) {
            forget_points(memories_, f);
            continue;
        }
        const auto depth = [&](const Vec3& at, Point& point) {
            return shape_->depth(at - projectile.position, offset, point.face);
        };
        const auto of_ply = [&] {
            return quadrature_.at_nodes() ? PlyNormals() : normals.of(facet, surface, x);
        };
        press(pair, {x, v, dt}, sliding_share, memories_.take(f), depth, of_ply, forces);
    }
}

}  // namespace weavefront::contact
