/// Bodies that rub on plies.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "surfaces.hpp"
#include "translating.hpp"
#include "weavefront/contact/ply_contact.hpp"
#include "weavefront/contact/projectile_contact.hpp"
#include "weavefront/contact/projectile_on_frame.hpp"

namespace weavefront::test {
namespace {

constexpr double k = 5e12, mu = 0.3, side = 8e-3, thickness = 0.14e-3;
const double stiffness_ratio = scene::Friction{}.stiffness_ratio;

scene::ContactLaw with_friction(double of_static, double of_kinetic, double damping = 0) {
    return {.stiffness = k,
            .unloading = 1,
            .damping = damping,
            .friction = scene::Friction{.static_coefficient = of_static, .kinetic_coefficient = of_kinetic}};
}

/// Sums of the forces of a step, of the pressures and of friction.
struct Sums {
    Assembled pressed, rubbed;
};

/// A rigid body over one flat ply that does not move.
class OnPly {
  public:
    OnPly(const scene::Projectile& shape, const scene::ContactLaw& law, const Translating& state,
          double time_step)
        : body(state),
          dt(time_step),
          contact_(body::make_shape(shape), body, law, 0.25e-3, plies().surface, plies().x) {
        contact_.update_candidates(plies_.surface, contact::SweptBounds(plies_.x),
                                   contact::SweptBounds({&body.position, 1}).of_node(0), 1e-3);
    }

    /// Moves the body by a step at its velocity. @return the forces on the ply
    Sums step() {
        body.position += dt * body.velocity;
        const Positions v(plies_.x.size(), Vec3::Zero());
        contact::ContactForces forces;
        contact_.evaluate(plies_.surface, plies_.fresh_normals(), plies_.x, v, body, dt, 1, forces);
        return {assemble(forces.pairs, plies_.x), assemble(forces.friction, plies_.x)};
    }

    Translating body;
    double dt;  // s

  private:
    Plies& plies() {
        if (plies_.x.empty()) plies_.add(8, {.z = 0, .thickness = 0, .areal_density = 0.2}, flat(side, 0));
        return plies_;
    }
    Plies plies_;
    contact::ProjectileContact contact_;
};

constexpr double radius = 2.69e-3;
const scene::Projectile block{.shape = scene::Shape::cylinder, .diameter = 2 * radius, .length = 10e-3};
// The points that it slides over come under its rounded edge and not against its side.
constexpr double edge_radius = 0.5e-3;
const scene::Projectile rounded_block{.shape = scene::Shape::cylinder,
                                      .diameter = 2 * (radius + edge_radius),
                                      .edge_radius = edge_radius,
                                      .length = 10e-3};

TEST(Friction, OfADraggedSphereIsElasticAndThenTheCoefficientTimesTheNormalForce) {
    const scene::Projectile sphere{.shape = scene::Shape::sphere, .diameter = 5e-3};
    OnPly sliding(sphere, with_friction(mu, mu), {{0, 0, -1e-6}, {0, 0, 100}}, 1e-8);
    for (int n = 0; n < 40; ++n) sliding.step();
    sliding.body.velocity = {0.6, 0.8, 0};
    double normal = 0, last = 0;
    for (int n = 0; n < 4000; ++n) {
        const auto [pressed, rubbed] = sliding.step();
        normal = pressed.on_slaves.z();
        const Vec3 along = rubbed.on_slaves;
        EXPECT_LT(std::abs(along.z()), 1e-12 * normal);
        EXPECT_LT((along - along.dot(Vec3(0.6, 0.8, 0)) * Vec3(0.6, 0.8, 0)).norm(), 1e-12 * normal);
        EXPECT_GE(along.norm(), last * (1 - 1e-3));  // points enter and leave the circle of contact
        last = along.norm();
    }
    EXPECT_NEAR(last / (mu * normal), 1, 1e-12);
}

TEST(Friction, OfAFlatFaceThatSticksIsTheTangentialStiffnessTimesTheWay) {
    constexpr double depth = 20e-6, dt = 1e-8, speed = 9.7;
    OnPly sliding(block, with_friction(mu, 0.2), {{0, 0, -0.5e-6}, {0, 0, 50}}, dt);
    for (int n = 0; n < 41; ++n) sliding.step();
    ASSERT_NEAR(sliding.body.position.z(), depth, 1e-12);
    sliding.body.velocity = {0, speed, 0};
    const double to_slip = mu * depth / stiffness_ratio;
    for (double way = speed * dt; way < 2 * to_slip; way += speed * dt) {
        const auto [pressed, rubbed] = sliding.step();
        const double normal = pressed.on_slaves.z(),
                     expected = way < to_slip ? stiffness_ratio * way / depth : 0.2;
        // Points that have come under the rim on the way have less traction: the way over the diameter, and
        // the row of points that happens to be crossed.
        EXPECT_NEAR(rubbed.on_slaves.y() / normal, expected, 0.02 * expected) << way / to_slip;
    }
}

/// What a block does on a plane that is tilted slowly and then kept at an angle.
struct OnIncline {
    double way, acceleration, closed_way, closed_acceleration;
};

OnIncline tilt(double angle, double of_static, double of_kinetic) {
    constexpr double mass = 2e-3, weight = 20, dt = 2e-7;  // kg, N, s
    const double area = std::numbers::pi * radius * radius;
    const double period = 2 * std::numbers::pi * std::sqrt(mass / (stiffness_ratio * k * area));
    OnPly sliding(rounded_block, with_friction(of_static, of_kinetic, 0.5), {{0, 0, -dt}, {0, 0, 1}}, dt);
    sliding.step();
    sliding.body.velocity.setZero();
    const auto tilting = static_cast<int>(40 * period / dt), kept = tilting / 20;
    double at_rest = 0, speed = 0;
    for (int n = 0; n < 2 * tilting + kept; ++n) {
        // The first half of the time lets the block come to rest on the level plane.
        const double part = std::clamp(static_cast<double>(n - tilting) / tilting, 0.0, 1.0);
        const double now = angle * (1 - std::cos(std::numbers::pi * part)) / 2;
        const double grown = std::min(1.0, 4.0 * n / tilting);
        const auto [pressed, rubbed] = sliding.step();
        const Vec3 force =
            grown * weight * Vec3(std::sin(now), 0, std::cos(now)) - pressed.on_slaves - rubbed.on_slaves;
        sliding.body.velocity += dt / mass * force;
        if (n == tilting) at_rest = sliding.body.position.x();
        if (n == 2 * tilting) speed = sliding.body.velocity.x();
    }
    return {sliding.body.position.x() - at_rest, (sliding.body.velocity.x() - speed) / (kept * dt),
            weight * std::sin(angle) / (stiffness_ratio * k * area),
            weight / mass * (std::sin(angle) - of_kinetic * std::cos(angle))};
}

TEST(Friction, HoldsABlockOnAPlaneBelowTheAngleOfFriction) {
    const auto held = tilt(std::atan(0.95 * mu), mu, 0.2);
    EXPECT_NEAR(held.way / held.closed_way, 1, 0.03);  // the area, as above
    EXPECT_LT(std::abs(held.acceleration), 0.01 * 20 / 2e-3) << "of gravity";
}

TEST(Friction, LetsABlockSlideAboveTheAngleOfFriction) {
    const auto sliding = tilt(std::atan(1.05 * mu), mu, 0.2);
    EXPECT_GT(sliding.way, 10 * sliding.closed_way);
    EXPECT_NEAR(sliding.acceleration / sliding.closed_acceleration, 1, 0.01);
}

TEST(Friction, OfPliesIsEqualAndOppositeAndGrowsToTheCoefficientTimesTheNormalForce) {
    constexpr double gap = 0.2e-3, depth = 10e-6, step = 1e-7;
    Plies plies;
    plies.add(8, {.z = 0, .thickness = thickness, .areal_density = 0.2}, flat(side, 0));
    plies.add(11, {.z = gap, .thickness = thickness, .areal_density = 0.2}, flat(1.2 * side, gap));
    contact::PlyContact contact(with_friction(mu, 0.2), 0.5e-3, plies.surface, plies.x);
    contact.update_candidates(plies.surface, contact::SweptBounds(plies.x), plies.x, 1e-3);
    const double to_slip = mu * depth / stiffness_ratio;
    Positions v(plies.x.size(), Vec3::Zero());
    contact::ContactForces forces;
    const auto advance = [&](const Vec3& velocity) {
        for (std::size_t n = 0; n < 81; ++n) v[n] = velocity, plies.x[n] += step * velocity;
        forces.clear();
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, step, 1, forces);
        return assemble(forces.friction, plies.x);
    };
    for (int n = 0; n < 100; ++n) advance({0, 0, (gap - thickness + depth) / (100 * step)});
    const double normal = k * depth * side * side;
    double way = 0;
    for (int n = 0; n < 100; ++n) {
        const auto sum = advance({0.03 * to_slip / step, 0, 0});
        way += 0.03 * to_slip;
        const double expected = way < to_slip ? stiffness_ratio * way / depth : 0.2;
        EXPECT_NEAR(-sum.on_slaves.x() / normal, expected, 1e-9) << "it holds the moving ply back";
        EXPECT_LT(sum.net.norm(), 1e-13 * sum.on_slaves.norm());
        // The two sides act on mid-surfaces a distance apart.
        EXPECT_NEAR(sum.moment.y() / (sum.on_slaves.x() * (thickness - depth)), -1, 1e-6);
    }
    EXPECT_EQ(forces.pairs.size(), forces.friction.size());
}

TEST(Friction, OfABarHoldsTheProjectileBack) {
    const scene::Projectile plate{.shape = scene::Shape::cylinder,
                                  .diameter = 6e-3,
                                  .edge_radius = 0.5e-3,
                                  .length = 10e-3,
                                  .mass = 2e-3};
    const scene::Frame frame{.half_opening = {10e-3, std::nullopt}, .edge_radius = 1e-3};
    contact::ProjectileOnFrame bars(plate, frame, with_friction(mu, mu), 2e-3);
    Translating state{{16e-3, 0, 1.5e-3}, {0, 40, 40}};
    const Vec3 start = state.velocity;
    constexpr double dt = 1e-8;
    for (int n = 0; n < 6000; ++n) {
        const auto [pressure, friction] = bars.evaluate(state, n > 0 ? dt : 0);
        EXPECT_LE(friction.force.norm(), mu * pressure.force.norm() * (1 + 1e-12));
        state.velocity += dt / plate.mass * (pressure.force + friction.force);
        state.position += dt * state.velocity;
    }
    // It slides all the time: the impulse along the bar is that of the pressure times the coefficient.
    EXPECT_NEAR((start.y() - state.velocity.y()) / (mu * (start.z() - state.velocity.z())), 1, 1e-9);
}

}  // namespace
}  // namespace weavefront::test
