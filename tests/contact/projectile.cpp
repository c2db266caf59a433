/// Depths below the projectile's surface.

#include "weavefront/contact/projectile.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using contact::ProjectileShape;
using contact::Side;

constexpr double diameter = 5e-3, edge = 0.4e-3, length = 8e-3, offset = 0.1e-3;
constexpr double R = diameter / 2 + offset, arc = edge + offset;  // of the inflated shape

ProjectileShape cylinder() {
    return {{.shape = scene::Shape::cylinder, .diameter = diameter, .edge_radius = edge, .length = length},
            offset};
}

/// Signed distance to the inflated cylinder with round rims, positive inside.
double distance(const Vec3& point) {
    const double out = std::hypot(point.x(), point.y()) - (R - arc),
                 up = std::abs(point.z() + length / 2) - (length / 2 + offset - arc);
    return arc - std::hypot(std::max(out, 0.0), std::max(up, 0.0)) - std::min(std::max(out, up), 0.0);
}

TEST(ProjectileShape, ASphereIsItsDistance) {
    const ProjectileShape shape({.shape = scene::Shape::sphere, .diameter = diameter}, offset);
    const Vec3 centre(0, 0, -diameter / 2);
    std::mt19937_64 random(1);
    for (int n = 0; n < 10000; ++n) {
        const Vec3 away(uniform(random, -1.2, 1.2) * R, uniform(random, -1.2, 1.2) * R,
                        uniform(random, -1.2, 1.2) * R);
        Side side = Side::none;
        const auto found = shape.depth(centre + away, side);
        ASSERT_EQ(found.has_value(), away.norm() < R);
        if (!found) continue;
        ASSERT_NEAR(found->depth, R - away.norm(), 1e-15);
        ASSERT_NEAR(found->normal.dot(away.normalized()), 1, 1e-14);
    }
}

TEST(ProjectileShape, InsideIsInsideTheInflatedCylinder) {
    const auto shape = cylinder();
    EXPECT_DOUBLE_EQ(shape.radius(), R);
    EXPECT_DOUBLE_EQ(shape.front(), offset);
    EXPECT_DOUBLE_EQ(shape.rear(), -length - offset);
    std::mt19937_64 random(2);
    for (int n = 0; n < 100000; ++n) {
        const Vec3 point(uniform(random, -1.1, 1.1) * R, uniform(random, -1.1, 1.1) * R,
                         uniform(random, -1.1, 0.1) * length);
        Side side = Side::none;
        const auto found = shape.depth(point, side);
        const double exact = distance(point);
        if (std::abs(exact) < 1e-12) continue;
        ASSERT_EQ(found.has_value(), exact > 0) << point.transpose();
        if (!found) continue;
        ASSERT_NEAR(found->normal.norm(), 1, 1e-14);
        ASSERT_GT(found->depth, 0);
        ASSERT_NE(side, Side::none);
    }
}

/// Points of the surface and their outward normals: face, front rim and side.
struct SurfacePoint {
    Vec3 at, normal;
};

SurfacePoint random_surface_point(std::mt19937_64& random) {
    const double angle = uniform(random, 0, 2 * std::numbers::pi), c = std::cos(angle), s = std::sin(angle);
    const double where = uniform(random, 0, 3);
    if (where < 1) {
        const double radius = where * (R - arc);
        return {{radius * c, radius * s, offset}, {0, 0, 1}};
    }
    if (where < 2) {
        const double up = (where - 1) * std::numbers::pi / 2, radius = R - arc + arc * std::cos(up);
        const Vec3 normal(std::cos(up) * c, std::cos(up) * s, std::sin(up));
        return {{radius * c, radius * s, offset - arc + arc * std::sin(up)}, normal};
    }
    return {{R * c, R * s, offset - arc - (where - 2) * (length - 2 * arc)}, {c, s, 0}};
}

TEST(ProjectileShape, TheDepthGrowsFromZeroAlongTheNormal) {
    const auto shape = cylinder();
    std::mt19937_64 random(3);
    for (int n = 0; n < 10000; ++n) {
        const auto [at, normal] = random_surface_point(random);
        Side side = Side::none;
        ASSERT_FALSE(shape.depth(at + 1e-9 * normal, side));
        side = Side::none;
        const double small = 1e-7;
        const auto found = shape.depth(at - small * normal, side);
        ASSERT_TRUE(found);
        // seen along the axis or the radius on a rim: the depth is first order, never more than the distance
        ASSERT_LE(found->depth, small * (1 + 1e-6));
        ASSERT_GT(found->depth, 0);
        const double on_arc = std::hypot(at.x(), at.y()) - (R - arc);
        if (on_arc < 0.9 * arc || on_arc > arc * (1 - 1e-9) || side == Side::side) {
            ASSERT_NEAR(found->depth, small, 1e-2 * small) << at.transpose();
            ASSERT_GT(found->normal.dot(normal), 1 - 1e-3);
        }
    }
}

TEST(ProjectileShape, APressOnTheFaceFadesAcrossTheRim) {
    // depth times normal of points that came in at the front, out to the radius: steps get small with those
    // of the radius
    const auto shape = cylinder();
    for (const double z : {-0.05e-3, -0.3e-3, -1e-3}) {
        const auto largest_jump = [&](int steps) {
            Vec3 last(0, 0, offset - z);
            double jump = 0;
            for (int i = 0; i <= steps; ++i) {
                Side side = Side::front;
                const auto found = shape.depth({R * i / steps, 0, z}, side);
                const Vec3 push = found ? Vec3(found->depth * found->normal) : Vec3::Zero();
                jump = std::max(jump, (push - last).norm());
                last = push;
            }
            return jump;
        };
        // sqrt(1 - outward^2) leaves the radius like a root
        EXPECT_LT(largest_jump(1000), 2 * (offset - z) * std::sqrt(2 * R / arc / 1000));
        EXPECT_LT(largest_jump(64000), largest_jump(1000) / 6);
    }
}

TEST(ProjectileShape, APointKeepsItsSideUntilItWasOutside) {
    const auto shape = cylinder();
    Side front = Side::none, lateral = Side::none;
    const double near_rim = 0.999 * R;
    // comes in from ahead, then lies nearer to the side than to the face
    EXPECT_FALSE(shape.depth({0.5 * R, 0, 2 * offset}, front));
    EXPECT_EQ(front, Side::front);
    const auto still = shape.depth({0.7 * R, 0, -4e-3}, front);
    ASSERT_TRUE(still);
    EXPECT_EQ(still->normal, Vec3(0, 0, 1));
    EXPECT_NEAR(still->depth, 4e-3 + offset, 1e-15);
    // comes in from the side, then lies nearer to the face
    EXPECT_FALSE(shape.depth({1.1 * R, 0, -2e-3}, lateral));
    EXPECT_EQ(lateral, Side::none);
    const auto beside = shape.depth({near_rim, 0, -2e-3}, lateral);
    ASSERT_TRUE(beside);
    EXPECT_EQ(lateral, Side::side);
    EXPECT_NEAR(beside->normal.x(), 1, 1e-15);
    EXPECT_EQ(shape.depth({0.5 * R, 0, -0.5e-3}, lateral)->normal.z(), 0);
    // once outside it may come in anywhere
    EXPECT_FALSE(shape.depth({1.1 * R, 0, 0}, lateral));
    EXPECT_FALSE(shape.depth({0.1 * R, 0, -length - 2 * offset}, lateral));
    EXPECT_EQ(shape.depth({0.1 * R, 0, -length}, lateral)->normal, Vec3(0, 0, -1));
}

}  // namespace
}  // namespace weavefront::test
