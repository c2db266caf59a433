/// Surfaces of triangles against closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.hpp"

namespace weavefront::test {
namespace {

using body::make_shape;

TEST(Box, HasTheMeasuresOfTheTextbook) {
    const auto shape = make_shape(box());
    const auto [x, y, z] = box().size;
    const auto found = shape->mass_properties();
    EXPECT_NEAR(found.volume / (x * y * z), 1, 1e-14);
    EXPECT_NEAR((found.centroid - Vec3(0, 0, -z / 2)).norm(), 0, 1e-15);
    EXPECT_NEAR(found.inertia(0, 0) / ((y * y + z * z) / 12), 1, 1e-13);
    EXPECT_NEAR(found.inertia(2, 2) / ((x * x + y * y) / 12), 1, 1e-13);
    EXPECT_NEAR(found.inertia(0, 1), 0, 1e-18);
    // a stripe of 2000 at an edge may be counted or not
    EXPECT_NEAR(shape->presented_area({0, 0, -1}) / (x * y), 1, 1e-3);
    EXPECT_NEAR(shape->presented_area({1, 0, 0}) / (y * z), 1, 1e-3);
    EXPECT_NEAR(shape->presented_area({1, 2, 2}) * 3 / (y * z + 2 * x * z + 2 * x * y), 1, 1e-3);
    EXPECT_EQ(shape->bounds().low, Vec3(-x / 2, -y / 2, -z));
    EXPECT_EQ(shape->bounds().high, Vec3(x / 2, y / 2, 0));
    EXPECT_DOUBLE_EQ(shape->radius(), 5e-3);
}

/// Signed distance to the box, positive outside.
double distance_to_box(const Vec3& point) {
    const auto [x, y, z] = box().size;
    const Vec3 beyond = (point + Vec3(0, 0, z / 2)).cwiseAbs() - Vec3(x, y, z) / 2;
    return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

TEST(Box, ANewPointSeesItsDistance) {
    const auto shape = make_shape(box());
    std::mt19937_64 random(1);
    for (int n = 0; n < 20000; ++n) {
        const Vec3 point(uniform(random, -5e-3, 5e-3), uniform(random, -4e-3, 4e-3),
                         uniform(random, -21e-3, 1e-3));
        body::Face face = 0;
        const auto found = shape->depth(point, offset, face);
        const double exact = offset - distance_to_box(point);
        if (std::abs(exact) < 1e-12) continue;
        ASSERT_EQ(found.has_value(), exact > 0) << point.transpose();
        ASSERT_GT(face, 0);
        if (!found) continue;
        ASSERT_NEAR(found->normal.norm(), 1, 1e-14);
        // At the rim of the inflated edge a face may be left early by its width: never deeper than it is.
        ASSERT_NEAR(found->depth, exact, 1e-14) << point.transpose();
    }
}

TEST(Fsp, HasTheMeasuresOfACylinderLessTwoHoofs) {
    const auto shape = make_shape(fsp());
    const double a = fsp().flat_width / 2, slope = std::tan(fsp().flat_angle),
                 chord = std::sqrt(R * R - a * a);
    // integral of 2 sqrt(R2 - x2) (x - a) slope from a to R, twice
    const double hoof =
        slope * (2.0 / 3 * chord * chord * chord - a * (R * R * std::acos(a / R) - a * chord));
    const double volume = pi * R * R * L - 2 * hoof;
    const auto found = shape->mass_properties();
    // 96 chords of the circle: 2 pi^2/3 / 96^2
    EXPECT_NEAR(found.volume / volume, 1, 7.3e-4);
    EXPECT_LT(found.volume, volume);
    EXPECT_NEAR(found.centroid.x(), 0, 1e-12);
    EXPECT_NEAR(found.centroid.y(), 0, 1e-12);
    EXPECT_NEAR(shape->presented_area({0, 0, 1}) / (pi * R * R), 1, 2e-3);
    const double down = slope * (R - a);
    EXPECT_NEAR(shape->presented_area({0, 1, 0}) / (2 * R * L - down * (R - a)), 1, 2e-3);
    EXPECT_NEAR(shape->presented_area({1, 0, 0}) / (2 * R * L), 1, 2e-3);
    EXPECT_EQ(shape->bounds().high.z(), 0);
    EXPECT_NEAR(shape->radius(), R, 1e-15);
    body::Face face = 0;
    const Vec3 flat(std::sin(fsp().flat_angle), 0, std::cos(fsp().flat_angle));
    EXPECT_FALSE(
        shape->depth(Vec3(0.7 * R, 0.1 * R, -slope * (0.7 * R - a)) + 2 * offset * flat, offset, face));
    const auto on_flat =
        shape->depth(Vec3(0.7 * R, 0.1 * R, -slope * (0.7 * R - a)) - offset * flat, offset, face);
    ASSERT_TRUE(on_flat);
    EXPECT_NEAR(on_flat->depth, 2 * offset, 1e-14);
    EXPECT_NEAR((on_flat->normal - flat).norm(), 0, 1e-12);
}

TEST(RingSegment, HasTheMeasuresOfItsSector) {
    const auto projectile = ring_segment();
    const auto shape = make_shape(projectile);
    const double outer = projectile.outer_radius, inner = outer - projectile.thickness,
                 sector = projectile.sector, width = projectile.width;
    const auto found = shape->mass_properties();
    // chords of 2 degrees: 1/6 of (1 deg)^2 less on both sides
    const double squares = outer * outer - inner * inner;
    EXPECT_NEAR(found.volume / (sector / 2 * squares * width), 1, 3e-4);
    const double middle =
        4 * std::sin(sector / 2) / (3 * sector) * (std::pow(outer, 3) - std::pow(inner, 3)) / squares;
    EXPECT_NEAR(found.centroid.z(), middle - outer, 3e-4 * outer);
    EXPECT_NEAR(found.centroid.x(), 0, 1e-12);
    EXPECT_NEAR(shape->presented_area({0, 0, 1}) / (2 * outer * std::sin(sector / 2) * width), 1, 1e-3);
    EXPECT_NEAR(shape->presented_area({0, 1, 0}) / (sector / 2 * squares), 1, 1e-3);
    EXPECT_EQ(shape->bounds().high.z(), 0);
    body::Face face = 0;
    // the inner side is concave
    const auto inside = shape->depth({0.1e-3, 1e-3, -projectile.thickness - offset / 2}, offset, face);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->depth, offset / 2, 3e-4 * inner);
    EXPECT_LT(inside->normal.z(), -0.99);
}

/// A needle: the normals of two triangles at its edges and its tip are more than a right angle apart.
TEST(Mesh, ASharpNeedleKnowsItsInside) {
    scene::Projectile projectile;
    projectile.shape = scene::Shape::mesh;
    projectile.triangles.points = {
        {0, 0, 0}, {1e-3, 0.1e-3, -9e-3}, {-1e-3, 0.1e-3, -9e-3}, {0, -0.1e-3, -8e-3}};
    projectile.triangles.corners = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const auto shape = make_shape(projectile);
    std::array<Vec3, 4> at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = Vec3(projectile.triangles.points[i].data());
    EXPECT_NEAR(
        shape->mass_properties().volume / ((at[1] - at[0]).dot((at[3] - at[0]).cross(at[2] - at[0])) / 6), 1,
        1e-14);
    std::mt19937_64 random(3);
    for (int n = 0; n < 20000; ++n) {
        const Vec3 point(uniform(random, -2e-3, 2e-3), uniform(random, -0.3e-3, 0.3e-3),
                         uniform(random, -10e-3, 1e-3));
        double highest = -1;
        for (const auto& [a, b, c] : projectile.triangles.corners) {
            const auto& corner = at[static_cast<std::size_t>(a)];
            const Vec3 normal = (at[static_cast<std::size_t>(b)] - corner)
                                    .cross(at[static_cast<std::size_t>(c)] - corner)
                                    .normalized();
            highest = std::max(highest, (point - corner).dot(normal));
        }
        body::Face face = 0;
        const bool found = shape->depth(point, 1e-9, face).has_value();
        ASSERT_TRUE(highest <= 1e-9 || !found) << point.transpose();
        ASSERT_TRUE(highest >= 0 || found) << point.transpose();
    }
}

}  // namespace
}  // namespace weavefront::test
