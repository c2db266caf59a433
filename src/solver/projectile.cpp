#include "weavefront/solver/projectile.hpp"

#include <algorithm>

namespace weavefront::solver {

namespace {

// Of the size of a projectile: less is rounding of two that touch.
constexpr double touching = 1e-6;

Vec3 vector_of(const std::array<double, 3>& components) {
    return {components[0], components[1], components[2]};
}

/// Those given, or those of the shape at uniform density.
body::Inertia inertia_of(const scene::Projectile& projectile, const body::MassProperties& uniform) {
    body::Inertia inertia{.mass = projectile.mass, .centre = uniform.centroid};
    for (std::size_t i = 0; i < 3; ++i)
        inertia.tensor[i] =
            projectile.inertia
                ? Vec3((*projectile.inertia)[i] * Vec3::Unit(static_cast<Eigen::Index>(i)))
                : Vec3(projectile.mass * uniform.inertia.row(static_cast<Eigen::Index>(i)).transpose());
    return inertia;
}

/// Largest distance of a corner of the bounds from a point, m.
double largest_arm(const body::Bounds& bounds, const Vec3& from) {
    return (bounds.low - from).cwiseAbs().cwiseMax((bounds.high - from).cwiseAbs()).norm();
}

/// Half of the diagonal of a projectile's bounds, m.
double half_diagonal(const body::Bounds& bounds) { return (bounds.high - bounds.low).norm() / 2; }

/// The deepest that points of one projectile are inside the other, m.
double deepest_point(const Projectile& of, const Projectile& in) {
    double deepest = 0;
    for (const auto& point : of.surface_points) {
        body::Face face = 0;
        const auto found = in.shape->depth(in.body.to_body(of.body.to_space(point)), 0, face);
        if (found) deepest = std::max(deepest, found->depth);
    }
    return deepest;
}

}  // namespace

Projectile make_projectile(const scene::Projectile& p) {
    const std::shared_ptr<const body::Shape> shape = body::make_shape(p);
    const auto inertia = inertia_of(p, shape->mass_properties());
    const auto bounds = shape->bounds();
    Projectile projectile{.body = body::RigidBody(inertia, p.turns),
                          .shape = shape,
                          .surface_points = shape->outline().points,
                          .arm = largest_arm(bounds, inertia.centre)};
    projectile.surface_points.emplace_back((bounds.low + bounds.high) / 2);
    projectile.body.place(vector_of(p.start()), body::Attitude(p.attitude), vector_of(p.velocity));
    if (p.turns) projectile.body.spin(vector_of(p.angular_velocity));
    return projectile;
}

double overlap(const Projectile& one, const Projectile& other) {
    const auto a = one.shape->bounds(), b = other.shape->bounds();
    const Vec3 apart = one.body.to_space((a.low + a.high) / 2) - other.body.to_space((b.low + b.high) / 2);
    if (apart.norm() > half_diagonal(a) + half_diagonal(b)) return 0;
    const double depth = std::max(deepest_point(one, other), deepest_point(other, one));
    return depth > touching * std::min(half_diagonal(a), half_diagonal(b)) ? depth : 0;
}

void ProjectileOverlap::look(const std::vector<Projectile>& projectiles, double now) {
    for (std::size_t a = 0; a < projectiles.size(); ++a)
        for (std::size_t b = a + 1; b < projectiles.size(); ++b) {
            const double found = overlap(projectiles[a], projectiles[b]);
            if (found <= depth) continue;
            depth = found, time = now;
            first = static_cast<std::int64_t>(a), second = static_cast<std::int64_t>(b);
        }
}

}  // namespace weavefront::solver
