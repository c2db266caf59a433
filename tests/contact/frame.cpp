/// Fabric that rests on the frame.

#include "weavefront/contact/frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "surfaces.hpp"
#include "weavefront/contact/frame_contact.hpp"

namespace weavefront::test {
namespace {

constexpr double half = 10e-3, radius = 1e-3, top = 2e-3;
const scene::Frame bars_across_y{.half_opening = {std::nullopt, half}, .edge_radius = radius};

TEST(FrameShape, OpeningAndTheSideOfTheShotAreOutside) {
    const contact::FrameShape shape(bars_across_y, top, 0);
    EXPECT_FALSE(shape.depth({0, 9.9e-3, 5e-3})) << "in the opening";
    EXPECT_FALSE(shape.depth({0, 15e-3, 1.9e-3})) << "on top";
    EXPECT_FALSE(shape.depth({50e-3, 0, 5e-3})) << "there are no bars across x";
    // the corner of the square that the arc leaves out
    EXPECT_FALSE(shape.depth({0, half + 0.1 * radius, top + 0.1 * radius}));
}

TEST(FrameShape, PushesBackTheShortWayOut) {
    const contact::FrameShape shape(bars_across_y, top, 0);
    const auto resting = shape.depth({3e-3, -15e-3, top + 0.2e-3}),
               beside = shape.depth({3e-3, -half - 0.2e-3, top + 5e-3});
    ASSERT_TRUE(resting && beside);
    EXPECT_NEAR(resting->depth, 0.2e-3, 1e-15);
    EXPECT_EQ(resting->normal, Vec3(0, 0, -1));
    EXPECT_NEAR(beside->depth, 0.2e-3, 1e-15);
    EXPECT_EQ(beside->normal, Vec3(0, 1, 0));
    // half-way round the arc
    const double inwards = (radius - 0.3e-3) / std::sqrt(2.0);
    const auto round = shape.depth({0, half + radius - inwards, top + radius - inwards});
    ASSERT_TRUE(round);
    EXPECT_NEAR(round->depth, 0.3e-3, 1e-15);
    EXPECT_LT((round->normal - Vec3(0, -1, -1) / std::sqrt(2.0)).norm(), 1e-12);
}

TEST(FrameShape, DepthIsContinuousAndItsGradientIsTheNormal) {
    const contact::FrameShape shape(bars_across_y, top, 0.07e-3);
    std::mt19937_64 random(1);
    constexpr double step = 1e-9;
    int inside = 0;
    for (int i = 0; i < 10000; ++i) {
        // not deeper than the arc's centre, beyond which the two ways out meet
        const Vec3 point(0, uniform(random, half - 0.2e-3, half + 3e-3),
                         uniform(random, top - 0.2e-3, top + 0.9e-3));
        const auto found = shape.depth(point);
        if (!found || found->depth < 2 * step) continue;
        ++inside;
        EXPECT_NEAR(found->normal.norm(), 1, 1e-12);
        const auto out = shape.depth(point + step * found->normal);
        ASSERT_TRUE(out);
        // curvature 1/edge over one step adds step^2/edge = 1e-15 m
        EXPECT_NEAR(found->depth - out->depth, step, 1e-4 * step);
        if (HasFailure()) return;
    }
    EXPECT_GT(inside, 2000);
}

TEST(FrameShape, OfARoundOpeningIsThatOfABarInEveryDirection) {
    const scene::Frame ring{.radius = half, .edge_radius = radius};
    const contact::FrameShape round(ring, top, 0.07e-3), straight(bars_across_y, top, 0.07e-3);
    std::mt19937_64 random(1);
    int inside = 0;
    for (int i = 0; i < 1000; ++i) {
        const double out = uniform(random, half - 0.2e-3, half + 3e-3),
                     z = uniform(random, top - 0.2e-3, top + 2e-3), angle = uniform(random, 0, 6.28);
        const Vec3 outward(std::cos(angle), std::sin(angle), 0);
        const Vec3 point = out * outward + z * Vec3::UnitZ();
        const auto found = round.depth(point), expected = straight.depth({0, out, z});
        ASSERT_EQ(found.has_value(), expected.has_value());
        EXPECT_TRUE(!found || round.may_touch(point, point));
        if (!found) continue;
        ++inside;
        EXPECT_NEAR(found->depth, expected->depth, 1e-15);
        EXPECT_NEAR(found->normal.dot(outward), expected->normal.y(), 1e-12);
        EXPECT_NEAR(found->normal.z(), expected->normal.z(), 1e-12);
    }
    EXPECT_GT(inside, 500);
    EXPECT_FALSE(round.depth({0, 0, 2 * top})) << "the middle of the opening";
    EXPECT_FALSE(round.may_touch({-7e-3, -7e-3, top}, {7e-3, 7e-3, 2 * top}));
}

TEST(FrameContact, HoldsTheRestingPlyByStiffnessDepthAndAreaAndLetsItLiftOff) {
    const double side = 24e-3, k = 5e12, dt = 1e-8, speed = 10, thickness = 0.14e-3, opening = 12e-3;
    Plies plies;
    plies.add(12, {.z = 0, .thickness = thickness, .areal_density = 0.2}, flat(side, 0));
    const scene::Frame frame{.half_opening = {std::nullopt, opening / 2}, .edge_radius = 0};
    contact::FrameContact contact(frame, {.stiffness = k, .unloading = 1, .damping = 0}, 0.1e-3,
                                  plies.surface, plies.x);
    const Positions v(plies.x.size(), Vec3(0, 0, speed));
    contact::ContactForces forces;
    contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, dt, 1, forces);
    EXPECT_TRUE(forces.pairs.empty()) << "it only rests at the start";
    for (auto& x : plies.x) x.z() += speed * dt;
    contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, dt, 1, forces);
    const auto sum = assemble(forces.pairs, plies.x);
    const double held = side * (side - opening);
    // the rounded rim of the inflated bars, half a thickness wide on both sides, holds less
    EXPECT_NEAR(sum.on_slaves.z() / (-k * speed * dt * held), 1, 2 * side * thickness / 2 / held + 0.02);
    // on the arc normals lean into the opening, on both sides alike
    EXPECT_NEAR(sum.on_slaves.y(), 0, 1e-9 * std::abs(sum.on_slaves.z()));
    for (auto& x : plies.x) x.z() -= 2 * speed * dt;
    forces.clear();
    contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, dt, 1, forces);
    EXPECT_TRUE(forces.pairs.empty()) << "fabric may lift off";
}

}  // namespace
}  // namespace weavefront::test
