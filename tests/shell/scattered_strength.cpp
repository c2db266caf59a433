#include "weavefront/shell/scattered_strength.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "../fabric/kevlar129.hpp"

namespace weavefront::shell {
namespace {

constexpr double modulus = 12, gauge_length = 0.1;

scene::Fabric scattered(std::int64_t seed = 1) {
    auto fabric = weavefront::test::unequal_kevlar129();
    fabric.failure->scatter =
        scene::Scatter{.weibull_modulus = modulus, .gauge_length = gauge_length, .seed = seed};
    return fabric;
}

// Links of the fill, and the distance of its yarns.
constexpr double link = 0.909e-3, spacing = 0.8e-3;

using Corners = std::array<Eigen::Vector3d, 4>;

Corners rectangle(double x0, double x1, double y0, double y1) {
    return {{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}};
}

/// Some links of one fill yarn.
Corners piece(std::int64_t yarn, std::int64_t first, std::int64_t links) {
    const auto y = static_cast<double>(yarn) * spacing, x = static_cast<double>(first) * link;
    return rectangle(x, x + static_cast<double>(links) * link, y, y + spacing);
}

/// Fill strengths of pieces of so many links.
std::vector<double> strengths_of(std::int64_t links, std::int64_t pieces_a_yarn, std::int64_t yarns) {
    const ScatteredStrength strengths(scattered(), 0, 0);
    std::vector<double> values;
    for (std::int64_t yarn = -yarns / 2; yarn < yarns - yarns / 2; ++yarn)
        for (std::int64_t i = -pieces_a_yarn / 2; i < pieces_a_yarn - pieces_a_yarn / 2; ++i)
            values.push_back(strengths.of(piece(yarn, i * links, links)).fill);
    return values;
}

/// Largest distance of the empirical distribution from the weakest-link law of pieces of so many links.
double kolmogorov_distance(std::vector<double> values, std::int64_t links) {
    std::ranges::sort(values);
    const double length = static_cast<double>(links) * link, gamma = std::tgamma(1 + 1 / modulus);
    const auto n = static_cast<double>(values.size());
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double expected = -std::expm1(-length / gauge_length * std::pow(values[i] * gamma, modulus));
        const auto rank = static_cast<double>(i);
        largest = std::max({largest, std::abs(expected - rank / n), std::abs(expected - (rank + 1) / n)});
    }
    return largest;
}

TEST(ScatteredStrength, FollowsTheWeakestLinkLawAtEveryLength) {
    for (const std::int64_t links : {1, 2, 7, 40}) {
        const auto values = strengths_of(links, 100, 200);
        // Kolmogorov (1933): 1.95/sqrt(n) is passed with a probability of 1 in 1000
        EXPECT_LT(kolmogorov_distance(values, links), 1.95 / std::sqrt(static_cast<double>(values.size())))
            << links;
    }
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

TEST(ScatteredStrength, FallsWithTheLength) {
    const std::int64_t pieces = 100, yarns = 200;
    const double one = mean(strengths_of(1, pieces, yarns));
    // Weibull: deviation over mean is below 1.28/m. Four deviations of the mean, and of the first one, too.
    const double tolerance = 4 * 1.28 / modulus * std::sqrt(2.0 / static_cast<double>(pieces * yarns));
    for (const std::int64_t links : {4, 16})
        EXPECT_NEAR(mean(strengths_of(links, pieces, yarns)) / one,
                    std::pow(static_cast<double>(links), -1 / modulus), tolerance)
            << links;
    // 110 links are 99.99 mm, the gauge length but for 1e-4/m
    EXPECT_NEAR(mean(strengths_of(110, pieces, yarns)), 1, tolerance);
}

TEST(ScatteredStrength, APieceIsAsStrongAsItsWeakestPart) {
    const ScatteredStrength strengths(scattered(), 3, 0);
    for (std::int64_t i = -20; i < 20; ++i) {
        const auto of = [&](std::int64_t first, std::int64_t links) {
            return strengths.of(piece(5, first, links)).fill;
        };
        EXPECT_DOUBLE_EQ(of(3 * i, 3), std::min({of(3 * i, 1), of(3 * i + 1, 1), of(3 * i + 2, 1)}));
    }
}

TEST(ScatteredStrength, WarpRunsAcrossTheFill) {
    const ScatteredStrength strengths(scattered(), 0, 0);
    for (std::int64_t column = -4; column < 4; ++column) {
        const auto x = static_cast<double>(column) * link;
        double weakest_warp = 1e300, sum_of_fill = 0;
        for (int row = -2; row < 3; ++row) {
            const auto part = strengths.of(rectangle(x, x + link, row * spacing, (row + 1) * spacing));
            weakest_warp = std::min(weakest_warp, part.warp);
            sum_of_fill += part.fill;
        }
        const auto strip = strengths.of(rectangle(x, x + link, -2 * spacing, 3 * spacing));
        EXPECT_DOUBLE_EQ(strip.warp, weakest_warp);
        EXPECT_DOUBLE_EQ(strip.fill, sum_of_fill / 5);
    }
}

TEST(ScatteredStrength, AMiddleCountsOnEitherSideOfTheOrigin) {
    // elements that begin and end between the middles of links
    const ScatteredStrength strengths(scattered(), 0, 0);
    for (std::int64_t i = -6; i < 6; ++i)
        for (const auto& [offset, first] : {std::pair{0.3, i}, {0.7, i + 1}}) {
            const double x = (static_cast<double>(i) + offset) * link,
                         y = (static_cast<double>(i) + offset) * spacing;
            const auto part = strengths.of(rectangle(x, x + 2 * link, y, y + spacing));
            const auto one = strengths.of(piece(first, first, 1)),
                       other = strengths.of(piece(first, first + 1, 1));
            EXPECT_DOUBLE_EQ(part.fill, std::min(one.fill, other.fill)) << i << " and " << offset;
        }
}

TEST(ScatteredStrength, ElementsOfOneLinkAreEquallyStrong) {
    const ScatteredStrength strengths(scattered(), 0, 0);
    const auto whole = strengths.of(rectangle(0, link, 0, spacing));
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const double x = i * link / 4, y = j * spacing / 4;
            const auto part = strengths.of(rectangle(x, x + link / 4, y, y + spacing / 4));
            EXPECT_DOUBLE_EQ(part.fill, whole.fill);
            EXPECT_DOUBLE_EQ(part.warp, whole.warp);
        }
}

TEST(ScatteredStrength, YarnsOfAnElementBreakAtTheMeanOfTheirStrengths) {
    const ScatteredStrength strengths(scattered(), 0, 0);
    double sum = 0;
    for (std::int64_t yarn = -2; yarn < 3; ++yarn) sum += strengths.of(piece(yarn, 4, 6)).fill;
    const auto all = strengths.of(rectangle(4 * link, 10 * link, -2 * spacing, 3 * spacing));
    EXPECT_NEAR(all.fill, sum / 5, 1e-15 * 5);
}

TEST(ScatteredStrength, TurnsWithThePly) {
    for (const double angle : {0.3, 1.0, 2.5}) {
        const ScatteredStrength plain(scattered(), 0, 0), turned(scattered(), 0, angle);
        const Eigen::AngleAxisd turn(angle, Eigen::Vector3d::UnitZ());
        for (std::int64_t i = 0; i < 50; ++i) {
            const auto corners = rectangle(1.03e-3 * static_cast<double>(i),
                                           1.03e-3 * static_cast<double>(i) + 2.1e-3, 0.1e-3, 1.7e-3);
            Corners with;
            std::ranges::transform(corners, with.begin(),
                                   [&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return turn * x; });
            // lengths in the element, weights of the mean, are rounded
            EXPECT_NEAR(turned.of(with).fill, plain.of(corners).fill, 1e-12);
            EXPECT_NEAR(turned.of(with).warp, plain.of(corners).warp, 1e-12);
        }
    }
}

TEST(ScatteredStrength, EveryElementOfATurnedPlyHasAStrength) {
    const ScatteredStrength turned(scattered(), 0, 0.7);
    for (const double size : {0.05e-3, 0.5e-3, 3e-3})
        for (int i = 0; i < 200; ++i) {
            const double x = 0.37e-3 * i;
            const auto strength = turned.of(rectangle(x, x + size, -x, -x + size));
            EXPECT_GT(strength.fill, 0);
            EXPECT_TRUE(std::isfinite(strength.fill) && std::isfinite(strength.warp));
        }
}

TEST(ScatteredStrength, DependsOnSeedPlyAndDirection) {
    std::set<double> draws;
    for (const std::int64_t seed : {1, 2})
        for (const std::int32_t ply : {0, 1})
            for (const bool warp : {false, true})
                for (const std::int64_t yarn : {-1, 0, 1})
                    for (const std::int64_t place : {-1, 0, 1})
                        draws.insert(exponential_draw(seed, {ply, warp, yarn, place}));
    EXPECT_EQ(draws.size(), 72U);
}

TEST(ScatteredStrength, NeighboursAreUnrelated) {
    // mean product of n pairs of deviations of variance 1 deviates by 1/sqrt(n): four deviations
    const int n = 200;
    for (const auto& [across, along] : {std::pair{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
        double sum = 0;
        for (int yarn = 0; yarn < n; ++yarn)
            for (int place = 0; place < n; ++place)
                sum += (exponential_draw(1, {0, false, yarn, place}) - 1) *
                       (exponential_draw(1, {0, false, yarn + across, place + along}) - 1);
        EXPECT_LT(std::abs(sum / (n * n)), 4.0 / n);
    }
}

TEST(ScatteredStrength, HasTheSameBitsOnEveryProcessor) {
    EXPECT_EQ(exponential_draw(1, {0, false, 0, 0}), 0x1.f55f1c4d89598p-4);
    EXPECT_EQ(exponential_draw(12345, {7, true, -40, 123456}), 0x1.4119349e4a15p+1);
    EXPECT_EQ(relative_strength({.weibull_modulus = 20, .gauge_length = 0.2}, 0.7e-3, 0.25),
              0x1.4588944c865bap+0);
}

}  // namespace
}  // namespace weavefront::shell
