/// Depths below the surface of a sphere, and its measures.

#include <gtest/gtest.h>

#include <numbers>

#include "random_points.hpp"
#include "weavefront/body/shape.hpp"

namespace weavefront::test {
namespace {

constexpr double diameter = 5e-3, offset = 0.1e-3, R = diameter / 2 + offset;

TEST(Sphere, ItsDepthIsTheDistance) {
    const auto shape = body::make_shape({.shape = scene::Shape::sphere, .diameter = diameter});
    const Vec3 centre(0, 0, -diameter / 2);
    std::mt19937_64 random(1);
    for (int n = 0; n < 10000; ++n) {
        const Vec3 away(uniform(random, -1.2, 1.2) * R, uniform(random, -1.2, 1.2) * R,
                        uniform(random, -1.2, 1.2) * R);
        body::Face face = 0;
        const auto found = shape->depth(centre + away, offset, face);
        ASSERT_EQ(found.has_value(), away.norm() < R);
        if (!found) continue;
        ASSERT_NEAR(found->depth, R - away.norm(), 1e-15);
        ASSERT_NEAR(found->normal.dot(away.normalized()), 1, 1e-14);
    }
}

TEST(Sphere, ItsMeasuresAreThoseOfTheTextbook) {
    const auto shape = body::make_shape({.shape = scene::Shape::sphere, .diameter = diameter});
    const double r = diameter / 2;
    EXPECT_EQ(shape->radius(), r);
    EXPECT_EQ(shape->bounds().low.z(), -diameter);
    EXPECT_NEAR(shape->presented_area({1, 2, 3}) / (std::numbers::pi * r * r), 1, 1e-15);
    const auto found = shape->mass_properties();
    EXPECT_NEAR(found.volume / (4 * std::numbers::pi / 3 * r * r * r), 1, 1e-15);
    EXPECT_EQ(found.centroid, Vec3(0, 0, -r));
    EXPECT_NEAR(found.inertia(2, 2) / (0.4 * r * r), 1, 1e-15);
}

}  // namespace
}  // namespace weavefront::test
