#include "weavefront/contact/projectile_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weavefront::contact {

namespace {

bool is_upright(const body::RigidBody& projectile) {
    return !projectile.turns() && projectile.attitude().is_identity();
}

}  // namespace

ProjectileContact::ProjectileContact(std::shared_ptr<const body::Shape> shape,
                                     const body::RigidBody& projectile, const scene::ContactLaw& law,
                                     std::optional<double> spacing, const Surface& surface,
                                     std::span<const Vec3> x, std::uint16_t number)
    : number_(number),
      shape_(std::move(shape)),
      bounds_(shape_->bounds()),
      is_upright_(is_upright(projectile)),
      search_radius_(is_upright_ ? shape_->radius() : (bounds_.high - bounds_.low).norm() / 2),
      friction_(CoulombLaw::of(law)),
      quadrature_(spacing, surface, x),
      memories_(surface.owned) {
    for (const auto& ply : surface.plies)
        plies_.push_back(
            {ply.thickness / 2,
             PenaltyLaw(law, ply.areal_density)});  // damping takes the projectile for infinitely heavy
}

Vec3 ProjectileContact::half_extents(const body::RigidBody& projectile) const {
    const Vec3 half = (bounds_.high - bounds_.low) / 2;
    const auto along = [&](std::size_t axis) { return projectile.attitude().row(axis).cwiseAbs().dot(half); };
    return {along(0), along(1), along(2)};
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
        if (way.near(swept.of(facet),
                     search_radius_ + plies_[static_cast<std::size_t>(facet.ply)].offset + skin))
            candidates_.push_back(f);
    }
}

void ProjectileContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                                 std::span<const Vec3> v, const body::RigidBody& projectile, double dt,
                                 double sliding_share, ContactForces& forces) {
    const auto motion = projectile.motion();
    const Vec3 centre = middle(projectile), half = half_extents(projectile);
    const double radius = shape_->radius();
    // The fastest of its points moves so much faster than its centre of mass.
    const double of_turning =
        motion.angular_velocity.norm() * (half.norm() + (centre - motion.centre).norm());
    for (const auto f : candidates_) {
        const auto index = static_cast<std::size_t>(f);
        if (!surface.alive[index]) continue;
        const auto& facet = surface.facets[index];
        const auto ply = static_cast<std::size_t>(facet.ply);
        const double offset = plies_[ply].offset;
        const auto box = Box::around(facet, x);
        // Points within the margin note their face before they enter the projectile. Before the first step
        // their velocities are not known.
        double fastest = 0;
        for (const auto node : facet.nodes)
            fastest = std::max(fastest, (v[static_cast<std::size_t>(node)] - motion.velocity).squaredNorm());
        const double margin =
            dt > 0 ? 0.01 * (radius + offset) + 4 * dt * (std::sqrt(fastest) + of_turning) : radius + offset;
        const Vec3 around = half + Vec3::Constant(offset + margin);
        if (!box.meets({centre - around, centre + around})) {
            forget_points(memories_, f);
            continue;
        }
        const RigidPair pair{.facet = facet,
                             .area = surface.areas[index],
                             .rule = quadrature_.rule(f),
                             .law = plies_[ply].law,
                             .thickness = surface.plies[ply].thickness,
                             .body = Master::projectile,
                             .away = (box.low + box.high) / 2 - centre,
                             .motion = motion,
                             .turns = projectile.turns(),
                             .friction = friction_ ? &*friction_ : nullptr,
                             .projectile = number_};
        const auto depth = [&](const Vec3& at, Point& point) {
            auto found = shape_->depth(projectile.to_body(at), offset, point.face);
            if (found) found->normal = projectile.attitude().to_space(found->normal);
            return found;
        };
        const auto of_ply = [&] {
            return quadrature_.at_nodes() ? PlyNormals() : normals.of(facet, surface, x);
        };
        press(pair, {x, v, dt}, sliding_share, memories_.take(f), depth, of_ply, forces);
    }
}

}  // namespace weavefront::contact
