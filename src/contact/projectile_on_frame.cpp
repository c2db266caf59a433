#include "weavefront/contact/projectile_on_frame.hpp"

#include <array>
#include <numbers>

#include "weavefront/body/shape.hpp"

namespace weavefront::contact {

namespace {

/// Points of a projectile without a rim of its own that stays across z. A sphere is a rim about its centre.
std::vector<Vec3> outline_of(const scene::Projectile& projectile) {
    const bool is_along_z = !projectile.turns && projectile.attitude == std::array<double, 4>{1, 0, 0, 0};
    if (projectile.shape == scene::Shape::sphere ||
        (projectile.shape == scene::Shape::cylinder && is_along_z))
        return {};
    return body::make_shape(projectile)->outline().points;
}

double rim_radius(const scene::Projectile& projectile, bool has_outline) {
    if (has_outline) return 0;
    return projectile.shape == scene::Shape::sphere ? projectile.diameter / 2 : projectile.edge_radius;
}

double cross_section(const scene::Projectile& projectile) {
    return std::numbers::pi / 4 * projectile.diameter * projectile.diameter;
}

}  // namespace

ProjectileOnFrame::ProjectileOnFrame(const scene::Projectile& projectile, const scene::Frame& frame,
                                     const scene::ContactLaw& law, double top)
    : outline_(outline_of(projectile)),
      shape_(frame, top, rim_radius(projectile, !outline_.empty())),
      area_(cross_section(projectile)),
      inset_(rim_radius(projectile, !outline_.empty())),
      reach_(projectile.diameter / 2 - inset_),
      law_(law, projectile.mass / area_),
      friction_(CoulombLaw::of(law)),
      bars_(bars_of(frame)) {}

std::vector<ProjectileOnFrame::Bar> ProjectileOnFrame::bars_of(const scene::Frame& frame) {
    if (frame.radius) return {Bar{std::nullopt}};
    std::vector<Bar> bars;
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
        for (const double side : {1.0, -1.0}) bars.push_back({side * axis});
    return bars;
}

std::optional<ProjectileOnFrame::Touch> ProjectileOnFrame::deepest_in(
    const Bar& bar, const body::RigidBody& projectile) const {
    std::optional<Touch> deepest;
    const auto look = [&](const Vec3& point) {
        const auto found =
            shape_.depth_in_bar(point, bar.outward.value_or(FrameShape::away_from_axis(point)));
        if (found && (!deepest || found->depth > deepest->depth.depth)) deepest = Touch{point, *found};
    };
    if (outline_.empty()) {
        const Vec3 centre = projectile.to_space({0, 0, -inset_});
        look(centre + reach_ * bar.outward.value_or(FrameShape::away_from_axis(centre)));
    }
    for (const auto& point : outline_) look(projectile.to_space(point));
    return deepest;
}

FromFrame ProjectileOnFrame::evaluate(const body::RigidBody& projectile, double dt) {
    const auto velocities = projectile.motion();
    FromFrame sum;
    for (auto& bar : bars_) {
        const auto touch = deepest_in(bar, projectile);
        if (!touch) {
            bar.penetration = {}, bar.traction = {};
            continue;
        }
        const auto& [point, found] = *touch;
        const Vec3 velocity = velocities.at(point);
        const double closing = -velocity.dot(found.normal);
        const RelativeMotion motion{closing, closing, velocity.norm()};
        const auto response = law_.advance(bar.penetration, found.depth, motion, dt, 1,
                                           {.dissipated_budget = 0, .sliding_share = 1});
        const auto add = [&](const Vec3& at, const Vec3& force, body::Wrench& to) {
            to.force += force;
            to.moment += (at - velocities.centre).cross(force);
        };
        add(point, response.pressure * area_ * found.normal, sum.pressure);
        if (!friction_) continue;
        const Vec3 surface = point - inset_ * found.normal;
        const auto& traction =
            friction_->advance(bar.traction, found.normal, response.pressure,
                               {.slip = -dt * velocities.at(surface), .turn = Vec3::Zero()});
        add(surface, area_ * traction, sum.friction);
    }
    return sum;
}

}  // namespace weavefront::contact
