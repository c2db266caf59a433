#include "weavefront/contact/projectile_on_frame.hpp"

#include <numbers>

namespace weavefront::contact {

namespace {

/// A sphere is a rim about its centre.
double rim_radius(const scene::Projectile& projectile) {
    return projectile.shape == scene::Shape::sphere ? projectile.diameter / 2 : projectile.edge_radius;
}

double cross_section(const scene::Projectile& projectile) {
    return std::numbers::pi / 4 * projectile.diameter * projectile.diameter;
}

}  // namespace

ProjectileOnFrame::ProjectileOnFrame(const scene::Projectile& projectile, const scene::Frame& frame,
                                     const scene::ContactLaw& law, double top)
    : shape_(frame, top, rim_radius(projectile)),
      area_(cross_section(projectile)),
      inset_(rim_radius(projectile)),
      reach_(projectile.diameter / 2 - inset_),
      law_(law, projectile.mass / area_),
      bars_{Bar{0, 1, {}}, Bar{0, -1, {}}, Bar{1, 1, {}}, Bar{1, -1, {}}} {}

body::Wrench ProjectileOnFrame::evaluate(const body::RigidBody& projectile, double dt) {
    const auto velocities = projectile.motion();
    body::Wrench wrench;
    for (auto& bar : bars_) {
        Vec3 point = projectile.position() - Vec3(0, 0, inset_);
        point[bar.axis] += bar.outward * reach_;
        const auto found = shape_.depth_in_bar(point, bar.axis, bar.outward);
        if (!found) {
            bar.penetration = {};
            continue;
        }
        const Vec3 velocity = velocities.at(point);
        const double closing = -velocity.dot(found->normal);
        const RelativeMotion motion{closing, closing, velocity.norm()};
        const auto response = law_.advance(bar.penetration, found->depth, motion, dt, 1,
                                           {.dissipated_budget = 0, .sliding_share = 1});
        const Vec3 force = response.pressure * area_ * found->normal;
        wrench.force += force;
        wrench.moment += (point - velocities.centre).cross(force);
    }
    return wrench;
}

}  // namespace weavefront::contact
