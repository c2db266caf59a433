/// Where nodes are expected, and that none leaves unseen.

#include "weavefront/contact/swept_bounds.hpp"

#include <gtest/gtest.h>

namespace weavefront::test {
namespace {

using contact::SweptBounds;

TEST(SweptBounds, SeeANodeThatLeavesAlongXOrYButNotAlongZ) {
    for (std::size_t count = 1; count < 20; ++count)
        for (std::size_t n = 0; n < count; ++n) {
            const std::vector<Vec3> start(count, Vec3(1, 2, 3));
            const SweptBounds expected(start);
            auto now = start;
            now[n] += Vec3(0.1, -0.1, 5);
            EXPECT_FALSE(expected.any_outside(now, 0.11)) << n << " of " << count;
            EXPECT_TRUE(expected.any_outside(now, 0.09)) << n << " of " << count;
            for (const Vec3& way : {Vec3(0.2, 0, 0), Vec3(-0.2, 0, 0), Vec3(0, 0.2, 0), Vec3(0, -0.2, 0)}) {
                now[n] = start[n] + way;
                EXPECT_TRUE(expected.any_outside(now, 0.11)) << n << " of " << count;
            }
        }
}

TEST(SweptBounds, CoverTheFlightOfANodeAndNoMore) {
    const std::vector<Vec3> start(3, Vec3(1, 2, 3)), v{{0, 0, 0}, {10, -20, 100}, {10, -20, 100}};
    const SweptBounds expected(start, v, 0.1);
    for (const std::size_t n : {1U, 2U}) {  // of two nodes looked at together, and alone
        const auto leaves = [&](double time, const Vec3& aside) {
            auto now = start;
            now[n] += time * v[n] + aside;
            return expected.any_outside(now, 0.05);
        };
        for (const double time : {0.0, 0.05, 0.1}) EXPECT_FALSE(leaves(time, {0, 0, 0})) << time;
        EXPECT_TRUE(leaves(-0.01, {0, 0, 0}));
        EXPECT_TRUE(leaves(0.11, {0, 0, 0}));
        EXPECT_TRUE(leaves(0, {-0.06, 0, 0}));
        EXPECT_FALSE(leaves(0, {-0.04, 0.04, 0}));
        EXPECT_TRUE(leaves(0.1, {0, -0.06, 0}));
    }
}

TEST(SweptBounds, OfAFacetContainThoseOfItsNodes) {
    const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
        v{{0, 0, 0}, {2, 0, 0}, {0, 0, 9}, {0, -3, 0}};
    const auto footprint = SweptBounds(x, v, 1).of(contact::Facet(0, {0, 1, 2, 3}, 0));
    EXPECT_EQ(footprint.x_low, 0);
    EXPECT_EQ(footprint.x_high, 3);
    EXPECT_EQ(footprint.y_low, -2);
    EXPECT_EQ(footprint.y_high, 1);
}

TEST(SweptBounds, DoNotCountIgnoredNodes) {
    const std::vector<Vec3> start(3, Vec3(1, 2, 3));
    SweptBounds expected(start);
    expected.ignore(1);
    auto now = start;
    now[1] += Vec3(1e3, -1e3, 0);
    EXPECT_FALSE(expected.any_outside(now, 0.1));
    now[2] += Vec3(0, 0.2, 0);
    EXPECT_TRUE(expected.any_outside(now, 0.1));
}

}  // namespace
}  // namespace weavefront::test
