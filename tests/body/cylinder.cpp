/// Depths below the surface of a cylinder, and its measures.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "random_points.hpp"
#include "weavefront/body/shape.hpp"

namespace weavefront::test {
namespace {

constexpr double diameter = 5e-3, edge = 0.4e-3, length = 8e-3, offset = 0.1e-3;
constexpr double R = diameter / 2 + offset, arc = edge + offset;  // of the inflated shape

constexpr double pi = std::numbers::pi;
constexpr body::Face none = 0, front = 1, side = 2;

std::unique_ptr<const body::Shape> cylinder(double edge_radius = edge) {
    return body::make_shape({.shape = scene::Shape::cylinder,
                             .diameter = diameter,
                             .edge_radius = edge_radius,
                             .length = length});
}

/// Signed distance to the inflated cylinder with round rims, positive inside.
double distance(const Vec3& point) {
    const double out = std::hypot(point.x(), point.y()) - (R - arc),
                 up = std::abs(point.z() + length / 2) - (length / 2 + offset - arc);
    return arc - std::hypot(std::max(out, 0.0), std::max(up, 0.0)) - std::min(std::max(out, up), 0.0);
}

TEST(Cylinder, InsideIsInsideTheInflatedCylinder) {
    const auto shape = cylinder();
    EXPECT_EQ(shape->radius(), diameter / 2);
    EXPECT_EQ(shape->bounds().low, Vec3(-diameter / 2, -diameter / 2, -length));
    EXPECT_EQ(shape->bounds().high, Vec3(diameter / 2, diameter / 2, 0));
    std::mt19937_64 random(2);
    for (int n = 0; n < 100000; ++n) {
        const Vec3 point(uniform(random, -1.1, 1.1) * R, uniform(random, -1.1, 1.1) * R,
                         uniform(random, -1.1, 0.1) * length);
        body::Face face = none;
        const auto found = shape->depth(point, offset, face);
        const double exact = distance(point);
        if (std::abs(exact) < 1e-12) continue;
        ASSERT_EQ(found.has_value(), exact > 0) << point.transpose();
        if (!found) continue;
        ASSERT_NEAR(found->normal.norm(), 1, 1e-14);
        ASSERT_GT(found->depth, 0);
        ASSERT_NE(face, none);
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

TEST(Cylinder, TheDepthGrowsFromZeroAlongTheNormal) {
    const auto shape = cylinder();
    std::mt19937_64 random(3);
    for (int n = 0; n < 10000; ++n) {
        const auto [at, normal] = random_surface_point(random);
        body::Face face = none;
        ASSERT_FALSE(shape->depth(at + 1e-9 * normal, offset, face));
        face = none;
        const double small = 1e-7;
        const auto found = shape->depth(at - small * normal, offset, face);
        ASSERT_TRUE(found);
        // seen along the axis or the radius on a rim: the depth is first order, never more than the distance
        ASSERT_LE(found->depth, small * (1 + 1e-6));
        ASSERT_GT(found->depth, 0);
        const double on_arc = std::hypot(at.x(), at.y()) - (R - arc);
        if (on_arc < 0.9 * arc || on_arc > arc * (1 - 1e-9) || face == side) {
            ASSERT_NEAR(found->depth, small, 1e-2 * small) << at.transpose();
            ASSERT_GT(found->normal.dot(normal), 1 - 1e-3);
        }
    }
}

TEST(Cylinder, APressOnTheFaceFadesAcrossTheRim) {
    // depth times normal of points that came in at the front, out to the radius: steps get small with those
    // of the radius
    const auto shape = cylinder();
    for (const double z : {-0.05e-3, -0.3e-3, -1e-3}) {
        const auto largest_jump = [&](int steps) {
            Vec3 last(0, 0, offset - z);
            double jump = 0;
            for (int i = 0; i <= steps; ++i) {
                body::Face face = front;
                const auto found = shape->depth({R * i / steps, 0, z}, offset, face);
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

TEST(Cylinder, APointKeepsItsFaceUntilItWasOutside) {
    const auto shape = cylinder();
    body::Face from_ahead = none, lateral = none;
    const double near_rim = 0.999 * R;
    // comes in from ahead, then lies nearer to the side than to the face
    EXPECT_FALSE(shape->depth({0.5 * R, 0, 2 * offset}, offset, from_ahead));
    EXPECT_EQ(from_ahead, front);
    const auto still = shape->depth({0.7 * R, 0, -4e-3}, offset, from_ahead);
    ASSERT_TRUE(still);
    EXPECT_EQ(still->normal, Vec3(0, 0, 1));
    EXPECT_NEAR(still->depth, 4e-3 + offset, 1e-15);
    // comes in from the side, then lies nearer to the face
    EXPECT_FALSE(shape->depth({1.1 * R, 0, -2e-3}, offset, lateral));
    EXPECT_EQ(lateral, none);
    const auto beside = shape->depth({near_rim, 0, -2e-3}, offset, lateral);
    ASSERT_TRUE(beside);
    EXPECT_EQ(lateral, side);
    EXPECT_NEAR(beside->normal.x(), 1, 1e-15);
    EXPECT_EQ(shape->depth({0.5 * R, 0, -0.5e-3}, offset, lateral)->normal.z(), 0);
    // once outside it may come in anywhere
    EXPECT_FALSE(shape->depth({1.1 * R, 0, 0}, offset, lateral));
    EXPECT_FALSE(shape->depth({0.1 * R, 0, -length - 2 * offset}, offset, lateral));
    EXPECT_EQ(shape->depth({0.1 * R, 0, -length}, offset, lateral)->normal, Vec3(0, 0, -1));
}

TEST(Cylinder, ItsMassPropertiesAreThoseOfTheTextbook) {
    const auto found = cylinder(0)->mass_properties();
    const double r = diameter / 2, across = (3 * r * r + length * length) / 12;
    EXPECT_NEAR(found.volume / (pi * r * r * length), 1, 1e-14);
    EXPECT_NEAR(found.centroid.z() / (-length / 2), 1, 1e-14);
    EXPECT_NEAR(found.inertia(0, 0) / across, 1, 1e-13);
    EXPECT_NEAR(found.inertia(1, 1) / across, 1, 1e-13);
    EXPECT_NEAR(found.inertia(2, 2) / (r * r / 2), 1, 1e-14);
    EXPECT_EQ(found.inertia(0, 1), 0);
}

TEST(Cylinder, RoundedEdgesTakeTheVolumeOfAPappusRing) {
    // Each edge takes a square less a quarter disk, turned about the axis at the distance of its centroid.
    const double r = diameter / 2, square = edge * edge, quarter = pi / 4 * square,
                 moment = square * (r - edge / 2) - quarter * (r - edge + 4 * edge / (3 * pi));
    const auto found = cylinder()->mass_properties();
    EXPECT_NEAR(found.volume / (pi * r * r * length - 2 * 2 * pi * moment), 1, 1e-14);
    EXPECT_NEAR(found.centroid.z() / (-length / 2), 1, 1e-14);
}

TEST(Cylinder, ItsShadowIsADiskARoundedRectangleAndBetweenThem) {
    const double r = diameter / 2, sine = 0.6, cosine = 0.8;
    EXPECT_NEAR(cylinder()->presented_area({0, 0, -3}) / (pi * r * r), 1, 1e-14);
    const double corners = (4 - pi) * edge * edge;
    EXPECT_NEAR(cylinder()->presented_area({1, -2, 0}) / (diameter * length - corners), 1, 1e-14);
    const double sharp = pi * r * r * cosine + diameter * length * sine;
    EXPECT_NEAR(cylinder(0)->presented_area({sine, 0, cosine}) / sharp, 1, 1e-14);
}

}  // namespace
}  // namespace weavefront::test
