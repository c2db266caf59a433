/// Distances of facets from each other.

#include "weavefront/contact/outline.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using Corners = std::array<Vec3, 4>;

Corners facet_at(std::mt19937_64& random, const Vec3& place) {
    Corners corners{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
    for (auto& corner : corners) corner += place + Vec3(uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2));
    return corners;
}

/// Least distance of 17 x 17 points of both facets.
double sampled_distance(const Corners& one, const Corners& other) {
    constexpr int n = 16;
    const auto at = [](const Corners& c, int i, int j) -> Vec3 {
        const double u = static_cast<double>(i) / n, w = static_cast<double>(j) / n;
        return (1 - u) * (1 - w) * c[0] + u * (1 - w) * c[1] + u * w * c[2] + (1 - u) * w * c[3];
    };
    double least = 1e300;
    for (int p = 0; p < (n + 1) * (n + 1); ++p)
        for (int q = 0; q < (n + 1) * (n + 1); ++q)
            least = std::min(least, (at(one, p % (n + 1), p / (n + 1)) - at(other, q % (n + 1), q / (n + 1))).norm());
    return least;
}

TEST(Outline, GivesABoundFromBelow) {
    std::mt19937_64 random(3);
    for (int n = 0; n < 300; ++n) {
        const auto one = facet_at(random, Vec3::Zero());
        const auto other = facet_at(random, {uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -1, 1)});
        EXPECT_LE(contact::Outline(one).distance_to(contact::Outline(other), 1e300), sampled_distance(one, other) * (1 + 1e-12));
    }
}

TEST(Outline, IsExactForFlatFacetsThatFaceEachOtherAndForCorners) {
    const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    const auto moved = [&](const Vec3& by) {
        auto corners = flat;
        for (auto& corner : corners) corner += by;
        return contact::Outline(corners);
    };
    const Eigen::AngleAxisd turn(0.4, Vec3(1, 2, 0.5).normalized());
    Corners turned, ahead;
    for (std::size_t a = 0; a < 4; ++a) turned[a] = turn * flat[a], ahead[a] = turn * (flat[a] + Vec3(0.3, 0.2, 0.25));
    EXPECT_NEAR(contact::Outline(turned).distance_to(contact::Outline(ahead), 1e300), 0.25, 1e-14);
    EXPECT_NEAR(contact::Outline(flat).distance_to(moved({1.3, 1.2, 0.4}), 1e300), Vec3(0.3, 0.2, 0.4).norm(), 1e-14);
}

}  // namespace
}  // namespace weavefront::test
