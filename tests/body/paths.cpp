/// Depth and normal along the ways of points.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "scenes.hpp"

namespace weavefront::test {
namespace {

using body::make_shape;

const std::vector<std::pair<std::string, scene::Projectile>> all{
    {"hemisphere", hemisphere()},
    {"cone", cone(12e-3)},
    {"rounded cone", cone(12e-3, 1e-3)},
    {"truncated cone", truncated_cone(6e-3, 4e-3)},
    {"ogive", ogive(3)},
    {"rounded ogive", ogive(2, 1e-3)},
    {"cup", cup()},
    {"box", box()},
    {"fsp", fsp()},
    {"ring segment", ring_segment()}};

Vec3 random_point(std::mt19937_64& random, const body::Bounds& bounds, double margin) {
    Vec3 point;
    for (int d = 0; d < 3; ++d) point[d] = uniform(random, bounds.low[d] - margin, bounds.high[d] + margin);
    return point;
}

Vec3 random_direction(std::mt19937_64& random) {
    Vec3 way;
    do way = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    while (way.norm() > 1 || way.norm() < 0.1);
    return way.normalized();
}

TEST(Paths, WhatIsInsideDoesNotDependOnTheMemory) {
    std::mt19937_64 random(1);
    for (const auto& [name, projectile] : all) {
        const auto shape = make_shape(projectile);
        body::Face face = 0;
        for (int n = 0; n < 3000; ++n) {
            const Vec3 point = random_point(random, shape->bounds(), 1e-3);
            body::Face fresh = 0;
            const auto found = shape->depth(point, offset, face), anew = shape->depth(point, offset, fresh);
            ASSERT_EQ(found.has_value(), anew.has_value()) << name << point.transpose();
            ASSERT_GT(face, 0) << name;
            if (!found) continue;
            ASSERT_GT(found->depth, 0) << name << point.transpose();
            ASSERT_NEAR(found->normal.norm(), 1, 1e-12) << name;
            ASSERT_TRUE(std::isfinite(found->radius)) << name;
        }
    }
}

/// A distance changes by the way at the most. Mixing two of them over a width of offset times the sine of the
/// angle adds their difference over this width: at 3 offsets at the most less than 7 times the way.
TEST(Paths, TheDepthOfAShallowPointDoesNotJump) {
    std::mt19937_64 random(2);
    for (const auto& [name, projectile] : all) {
        const auto shape = make_shape(projectile);
        int inside = 0;
        for (int n = 0; n < 150; ++n) {
            Vec3 point = random_point(random, shape->bounds(), 0.2e-3);
            const Vec3 way = random_direction(random) * 2e-6;
            body::Face face = 0;
            double last = 0;
            bool is_known = false;
            for (int step = 0; step < 1000; ++step, point += way) {
                body::Face fresh = 0;
                const auto nearest = shape->depth(point, offset, fresh),
                           found = shape->depth(point, offset, face);
                const double depth = found ? found->depth : 0;
                if (nearest && nearest->depth > 3 * offset) {  // deep: another side may be nearer
                    is_known = false;
                    face = 0;
                    continue;
                }
                const double change = is_known ? std::abs(depth - last) : 0;
                ASSERT_LT(change, 8 * way.norm()) << name << ' ' << point.transpose();
                is_known = true;
                last = depth;
                inside += found ? 1 : 0;
            }
        }
        EXPECT_GT(inside, 1000) << name;
    }
}

TEST(Paths, TheNormalTurnsOnlyAtEdges) {
    // Along the cone, the arc of the ogive and the flat of the chisel, 0.3 mm deep.
    const auto turns = [](const scene::Projectile& projectile, const Vec3& from, const Vec3& to,
                          double most) {
        const auto shape = make_shape(projectile);
        body::Face face = 0;
        Vec3 last = Vec3::Zero();
        for (int i = 0; i <= 1000; ++i) {
            const auto found = shape->depth(from + (to - from) * i / 1000, offset, face);
            ASSERT_TRUE(found);
            const double turned = i > 0 ? (found->normal - last).norm() : 0;
            ASSERT_LT(turned, most);
            last = found->normal;
        }
    };
    turns(cone(12e-3), {2e-3, 0, -6e-3}, {4e-3, 0, -11e-3}, 1e-12);
    turns(ogive(3), {1e-3, 0, -5e-3}, {4.5e-3, 0, -16e-3}, 1e-3);
    turns(hemisphere(), {0, 0, -0.3e-3}, {4.7e-3, 0, -12e-3}, 1e-2);  // over the joint with the shank
    turns(fsp(), {3.2e-3, -1e-3, -1e-3}, {4e-3, 1e-3, -1.6e-3}, 1e-12);
}

TEST(Paths, APointKeepsItsFaceWhileItProjectsOnIt) {
    const auto shape = make_shape(box());
    body::Face face = 0;
    EXPECT_FALSE(shape->depth({3.9e-3, 2.9e-3, 1e-3}, offset, face));
    const auto before = face;
    // 2 mm below the face, 0.1 mm below two sides
    const auto deep = shape->depth({3.9e-3, 2.9e-3, -2e-3}, offset, face);
    ASSERT_TRUE(deep);
    EXPECT_EQ(face, before);
    EXPECT_NEAR(deep->depth, 2e-3 + offset, 1e-15);
    EXPECT_EQ(deep->normal, Vec3(0, 0, 1));
    EXPECT_FALSE(shape->depth({4.2e-3, 0, -2e-3}, offset, face));
    const auto beside = shape->depth({3e-3, 0, -0.1e-3}, offset, face);
    ASSERT_TRUE(beside);
    EXPECT_EQ(beside->normal, Vec3(1, 0, 0));

    const auto round = make_shape(truncated_cone(6e-3, 4e-3));
    face = 0;
    EXPECT_FALSE(round->depth({1.9e-3, 0, 1e-3}, offset, face));
    const auto below_tip = round->depth({1.9e-3, 0, -2e-3}, offset, face);
    ASSERT_TRUE(below_tip);
    EXPECT_EQ(below_tip->normal, Vec3(0, 0, 1));
    EXPECT_NEAR(below_tip->depth, 2e-3 + offset, 1e-15);
}

}  // namespace
}  // namespace weavefront::test
