/// The projectile against the bars of the frame.

#include "weavefront/contact/projectile_on_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "translating.hpp"

namespace weavefront::test {
namespace {

constexpr double half = 10e-3, top = 2e-3, mass = 2e-3, k = 5.6e12;
const scene::Frame bars_across_x{.half_opening = {half, std::nullopt}, .edge_radius = 1e-3};
const scene::Projectile sphere{.shape = scene::Shape::sphere, .diameter = 6e-3, .mass = mass};
const scene::Projectile cylinder{
    .shape = scene::Shape::cylinder, .diameter = 6e-3, .edge_radius = 0.5e-3, .length = 10e-3, .mass = mass};

/// Velocity after a flight of 60 us.
Translating fly(const scene::Projectile& projectile, const Vec3& from, const Vec3& velocity,
                double unloading) {
    contact::ProjectileOnFrame bars(projectile, bars_across_x,
                                    {.stiffness = k, .unloading = unloading, .damping = 0}, top);
    Translating state{from, velocity};
    constexpr double dt = 1e-8;
    for (int step = 0; step < 6000; ++step) {
        state.velocity += dt / mass * bars.evaluate(state, step > 0 ? dt : 0).pressure.force;
        state.position += dt * state.velocity;
    }
    return state;
}

TEST(ProjectileOnFrame, ReboundsFromTheTopOfABar) {
    for (const auto* projectile : {&sphere, &cylinder})
        for (const double unloading : {1.0, 10.0}) {
            const auto state = fly(*projectile, {16e-3, 1e-3, 1e-3}, {0, 0, 100}, unloading);
            EXPECT_NEAR(-state.velocity.z() * std::sqrt(unloading) / 100, 1, 0.02);
            EXPECT_EQ(state.velocity.x(), 0);
        }
}

TEST(ProjectileOnFrame, IsTurnedAsideByTheEdgeOfABarWithoutLossWhereContactIsElastic) {
    for (const auto* projectile : {&sphere, &cylinder}) {
        const auto state = fly(*projectile, {8e-3, 0, 0}, {0, 0, 300}, 1);
        EXPECT_LT(state.velocity.x(), -50) << "towards the opening";
        EXPECT_NEAR(state.velocity.norm() / 300, 1, 1e-3);
        const auto mirrored = fly(*projectile, {-8e-3, 0, 0}, {0, 0, 300}, 1);
        EXPECT_EQ(mirrored.velocity, Vec3(-state.velocity.x(), 0, state.velocity.z()));
    }
}

TEST(ProjectileOnFrame, OfARingTurnsTheProjectileAsideAlikeInEveryDirection) {
    const scene::Frame ring{.radius = half, .edge_radius = 1e-3};
    const auto flown = [&](double angle) {
        contact::ProjectileOnFrame bar(sphere, ring, {.stiffness = k, .unloading = 1, .damping = 0}, top);
        Translating state{{8e-3 * std::cos(angle), 8e-3 * std::sin(angle), 0}, {0, 0, 300}};
        constexpr double dt = 1e-8;
        for (int step = 0; step < 6000; ++step) {
            state.velocity += dt / mass * bar.evaluate(state, step > 0 ? dt : 0).pressure.force;
            state.position += dt * state.velocity;
        }
        return state.velocity;
    };
    const Vec3 along_x = flown(0);
    EXPECT_LT(along_x.x(), -50) << "towards the opening";
    for (const double angle : {0.7, 2.1, 4.0}) {
        const Vec3 velocity = flown(angle);
        EXPECT_NEAR(velocity.x() * std::cos(angle) + velocity.y() * std::sin(angle), along_x.x(), 1e-6);
        EXPECT_NEAR(velocity.z(), along_x.z(), 1e-6);
    }
}

TEST(ProjectileOnFrame, PassesTheOpeningUntouched) {
    EXPECT_EQ(fly(sphere, {6.9e-3, 50e-3, 0}, {0, 0, 300}, 10).velocity, Vec3(0, 0, 300));
}

TEST(ProjectileOnFrame, OfAPlateWiderThanTheOpeningRestsOnBothBars) {
    auto plate = cylinder;
    plate.diameter = 24e-3;
    const auto state = fly(plate, {0, 0, 1e-3}, {0, 0, 100}, 1);
    EXPECT_NEAR(-state.velocity.z() / 100, 1, 0.02);
    EXPECT_NEAR(state.velocity.x(), 0, 1e-9);
}

TEST(ProjectileOnFrame, ANoseIsStoppedWhereItsOutlineIs) {
    auto round = cylinder;
    round.shape = scene::Shape::hemisphere;
    const auto state = fly(round, {16e-3, 1e-3, 1e-3}, {0, 0, 100}, 1);
    EXPECT_NEAR(-state.velocity.z() / 100, 1, 0.02);

    // The nose of a cone passes beside the bar that its base, 1 mm over the opening's edge, meets.
    auto pointed = cylinder;
    pointed.shape = scene::Shape::cone;
    pointed.nose_length = 9e-3;
    contact::ProjectileOnFrame bars(pointed, bars_across_x, {.stiffness = k, .unloading = 1, .damping = 0},
                                    top);
    const Vec3 velocity(0, 0, 100);
    EXPECT_EQ(bars.evaluate(Translating{Vec3(8e-3, 0, top + 3e-3), velocity}, 1e-8).pressure.force,
              Vec3(0, 0, 0));
    const Vec3 force = bars.evaluate(Translating{Vec3(8e-3, 0, top + 9.3e-3), velocity}, 1e-8).pressure.force;
    EXPECT_LT(force.z(), 0);
    EXPECT_LT(force.x(), 0);
}

}  // namespace
}  // namespace weavefront::test
