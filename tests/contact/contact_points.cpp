/// Distances of the points of a facet from other facets.

#include "weavefront/contact/contact_points.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using Corners = std::array<Vec3, 4>;
constexpr int points = 3;  // along an edge

Corners facet_at(std::mt19937_64& random, const Vec3& place) {
    Corners corners{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
    for (auto& corner : corners)
        corner +=
            place + Vec3(uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4));
    return corners;
}

Vec3 at(const Corners& c, double u, double w) {
    return (1 - u) * (1 - w) * c[0] + u * (1 - w) * c[1] + u * w * c[2] + (1 - u) * w * c[3];
}

/// Least distance of the points of one facet from 33 x 33 points of the other.
double sampled_distance(const Corners& one, const Corners& other) {
    constexpr int n = 32;
    double least = 1e300;
    for (int p = 0; p < points * points; ++p)
        for (int q = 0; q < (n + 1) * (n + 1); ++q) {
            const Vec3 from = at(one, (p % points + 0.5) / points, (p / points + 0.5) / points);
            least = std::min(least, (from - at(other, static_cast<double>(q % (n + 1)) / n,
                                               static_cast<double>(q / (n + 1)) / n))
                                        .norm());
        }
    return least;
}

double distance(const Corners& one, const Corners& other) {
    contact::Quadrature quadrature(2.0 / points);
    const Corners square{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(0, 2, 0)};
    const auto rule = quadrature.rule_for(square);
    return contact::ContactPoints(quadrature.rule(rule), one, quadrature.spanned(rule, one))
        .min_distance(other);
}

TEST(ContactPoints, MinDistanceIsALowerBound) {
    std::mt19937_64 random(3);
    int found = 0;
    for (int n = 0; n < 3000; ++n) {
        const auto one = facet_at(random, Vec3::Zero());
        const auto other =
            facet_at(random, {uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -1, 1)});
        const double bound = distance(one, other);
        ASSERT_LE(bound, sampled_distance(one, other) * (1 + 1e-12)) << n;
        if (bound > 0) ++found;
    }
    EXPECT_GT(found, 2000);
}

TEST(ContactPoints, MinDistanceIsExactForAFlatFacet) {
    const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    const Eigen::AngleAxisd turn(0.4, Vec3(1, 2, 0.5).normalized());
    const double margin = 0.5 / points;  // of the points to the edge
    const auto distance_moved = [&](const Vec3& by) {
        Corners here, there;
        for (std::size_t a = 0; a < 4; ++a) here[a] = turn * flat[a], there[a] = turn * (flat[a] + by);
        return distance(here, there);
    };
    EXPECT_NEAR(distance_moved({0.3, 0.2, 0.25}), 0.25, 1e-14);
    EXPECT_NEAR(distance_moved({0.3, 0.2, -0.25}), 0.25, 1e-14);
    EXPECT_NEAR(distance_moved({-1.3, 0.2, 0.25}), std::hypot(0.3 + margin, 0.25), 1e-14) << "beside it";
    EXPECT_NEAR(distance_moved({0.1, 1.2, 0}), 0.2 + margin, 1e-14);
    EXPECT_NEAR(distance_moved(Vec3::Zero()), 0, 1e-14);
}

// Facing facets of plies that bend together.
TEST(ContactPoints, MinDistanceIsCloseForAFacetWarpedAlike) {
    constexpr double apart = 0.1;
    for (const double warp : {0.02, 0.1}) {
        const Corners one{Vec3(0, 0, warp), Vec3(1, 0, -warp), Vec3(1, 1, warp), Vec3(0, 1, -warp)};
        auto other = one;
        for (auto& corner : other) corner += Vec3(0.01, 0, apart);
        const double slope = 2 * warp;  // at the edges at the most
        EXPECT_GT(distance(one, other), (apart - 0.01 * slope) * (1 - 4 * slope * slope)) << warp;
    }
}

TEST(ContactPoints, MinDistanceOfAFacetWithoutNormalIsThatOfItsBox) {
    std::mt19937_64 random(4);
    EXPECT_EQ(distance(facet_at(random, Vec3::Zero()),
                       {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0)}),
              0);
}

}  // namespace
}  // namespace weavefront::test
