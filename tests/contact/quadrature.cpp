/// Integration points of contact.

#include "weavefront/contact/quadrature.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using contact::Quadrature;

/// Sums of share N_a over a rule, its points, and whether padding has no share.
struct Sums {
    std::array<double, 4> of_N{};
    double share = 0;
    std::size_t points = 0;
};

Sums sums_of(const contact::QuadratureRule& rule) {
    Sums sums;
    for (const auto& batch : rule) {
        sums.points += batch.count;
        for (std::size_t i = 0; i < contact::batch_width; ++i) {
            sums.share += batch.share[i];
            EXPECT_NEAR(batch.N[0][i] + batch.N[1][i] + batch.N[2][i] + batch.N[3][i], 1, 1e-15);
            for (std::size_t a = 0; a < 4; ++a) sums.of_N[a] += batch.share[i] * batch.N[a][i];
            if (i >= batch.count) {
                EXPECT_EQ(batch.share[i], 0);
            }
        }
    }
    return sums;
}

TEST(Quadrature, IntegratesBilinearFunctionsExactly) {
    for (int n = 1; n <= 9; ++n)
        for (int m = 1; m <= 5; ++m) {
            const auto sums = sums_of(contact::quadrature(n, m));
            EXPECT_EQ(sums.points, static_cast<std::size_t>(n * m));
            EXPECT_NEAR(sums.share, 1, 1e-14);
            for (const double integral : sums.of_N)
                EXPECT_NEAR(integral, 0.25, 1e-14);  // they span the bilinear functions
        }
}

TEST(Quadrature, WithoutASpacingIsAtTheCorners) {
    Quadrature quadrature(std::nullopt);
    const auto& rule =
        quadrature.rule(quadrature.rule_for({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}));
    ASSERT_EQ(rule.size(), 1U);
    ASSERT_EQ(rule[0].count, 4U);
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(rule[0].N[a][i], a == i ? 1 : 0);
            EXPECT_EQ(rule[0].share[i], 0.25);
        }
}

TEST(Quadrature, PointsAreNoFartherApartThanAskedForNorMoreThanNeeded) {
    std::mt19937_64 random(4);
    const double spacing = 0.25e-3;
    Quadrature quadrature(spacing);
    for (int n = 0; n < 200; ++n) {
        const double a = uniform(random, 0.1, 3) * 1e-3, b = uniform(random, 0.1, 3) * 1e-3;
        const auto& rule = quadrature.rule(
            quadrature.rule_for({Vec3(0, 0, 0), Vec3(a, 0, 0), Vec3(a, b, 0), Vec3(0, b, 0)}));
        EXPECT_EQ(sums_of(rule).points,
                  static_cast<std::size_t>(std::ceil(a / spacing) * std::ceil(b / spacing)));
    }
    // 1 mm at 0.25 mm is four points wherever the element stands and however its corners are rounded
    for (int n = 0; n < 200; ++n) {
        const double x = uniform(random, -0.1, 0.1), y = uniform(random, -0.1, 0.1), a = 1e-3;
        const auto& rule = quadrature.rule(quadrature.rule_for(
            {Vec3(x, y, 0), Vec3(x + a, y, 0), Vec3(x + a, y + a, 0), Vec3(x, y + a, 0)}));
        EXPECT_EQ(sums_of(rule).points, 16U);
    }
}

}  // namespace
}  // namespace weavefront::test
