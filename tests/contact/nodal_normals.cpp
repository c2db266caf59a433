/// Smoothed normals.

#include "weavefront/contact/nodal_normals.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using contact::NodalNormals;

Vec3 cap(double u, double v) {
    const double x = 1.2 * (u - 0.5), y = 1.0 * (v - 0.5);
    return {x, y, -std::sqrt(1 - x * x - y * y)};
}

/// Largest angle between the normals and those of the unit sphere in the middle of the grid.
double error(int n) {
    Plies plies;
    plies.add(n, {}, cap);
    NodalNormals normals;
    normals.rebuild(plies.surface, plies.x.size());
    double largest = 0;
    for (int j = n / 4; j <= 3 * n / 4; ++j)
        for (int i = n / 4; i <= 3 * n / 4; ++i) {
            const int node = j * (n + 1) + i;
            const Vec3 normal = normals.at(node, plies.surface, plies.x).normalized();
            largest = std::max(
                largest,
                (normal + plies.x[static_cast<std::size_t>(node)]).norm());  // the cap is seen from inside
        }
    return largest;
}

TEST(NodalNormals, ConvergeToThoseOfASphere) {
    EXPECT_LT(error(40), 1e-3);
    EXPECT_GT(std::log2(error(20) / error(40)), 1.9);
}

TEST(NodalNormals, HaveTheSizeOfTheAreaAndLeaveOutTheEroded) {
    Plies plies;
    plies.add(3, {}, flat(3, 0));
    NodalNormals normals;
    normals.rebuild(plies.surface, plies.x.size());
    EXPECT_LT((normals.at(5, plies.surface, plies.x) - Vec3(0, 0, 4)).norm(), 1e-14);
    EXPECT_LT((normals.at(0, plies.surface, plies.x) - Vec3(0, 0, 1)).norm(), 1e-14);
    plies.surface.alive[0] = 0;
    plies.x[10].z() += 1;
    EXPECT_LT((normals.at(5, plies.surface, plies.x) - Vec3(0, 0, 4)).norm(), 1e-14)
        << "until told of new positions";
    normals.invalidate();
    EXPECT_NE(normals.at(5, plies.surface, plies.x).x(), 0);
    EXPECT_EQ(normals.at(0, plies.surface, plies.x), Vec3::Zero());
}

TEST(NodalNormals, HaveTheSameBitsWhateverTheOrderOfTheFacets) {
    std::mt19937_64 random(8);
    Plies plies;
    plies.add(10, {}, [&](double u, double v) {
        return Vec3(u + uniform(random, -0.03, 0.03), v, uniform(random, -0.03, 0.03));
    });
    NodalNormals normals, shuffled;
    normals.rebuild(plies.surface, plies.x.size());
    auto surface = plies.surface;
    std::ranges::shuffle(surface.facets, random);
    shuffled.rebuild(surface, plies.x.size());
    for (std::int32_t node = 0; node < 121; ++node)
        ASSERT_EQ(normals.at(node, plies.surface, plies.x), shuffled.at(node, surface, plies.x));
}

}  // namespace
}  // namespace weavefront::test
