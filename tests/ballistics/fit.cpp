#include "weavefront/ballistics/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace weavefront::ballistics {
namespace {

constexpr std::array probabilities{0.05, 0.5, 0.95};
constexpr double allowed_deviance = 3.841458820694124;  // chi squared of one degree, 95 %

/// Nine shots of which the maximum-likelihood estimates are known.
std::vector<Shot> nine_shots() {
    const std::array speeds{9.0, 11.0, 12.75, 11.88, 11.44, 12.03, 11.30, 11.62, 11.12};
    const std::array complete{false, false, true, true, false, true, true, true, true};
    std::vector<Shot> shots;
    for (std::size_t i = 0; i < speeds.size(); ++i) shots.push_back({speeds[i], complete[i]});
    return shots;
}

/// Four shots at each of two speeds, one of them complete at the lower one and three at the upper one.
std::vector<Shot> two_speeds() {
    std::vector<Shot> shots;
    for (int i = 0; i < 4; ++i) {
        shots.push_back({100, i == 0});
        shots.push_back({200, i != 0});
    }
    return shots;
}

/// Twenty shots around 400 m/s.
std::vector<Shot> twenty_shots() {
    std::vector<Shot> shots;
    for (int i = 0; i < 20; ++i) shots.push_back({380.0 + 2 * i, i > 12 || (i > 4 && i % 3 != 0)});
    return shots;
}

Fit fit_of(const std::vector<Shot>& shots, Distribution distribution = Distribution::normal,
           double confidence = 0.95) {
    return std::get<Fit>(fit(shots, distribution, probabilities, confidence));
}

/// -2 log of the likelihood ratio, with log-likelihoods written out.
double deviance(const std::vector<Shot>& shots, double v50, double sigma) {
    double sum = 0;
    for (const Shot& shot : shots) {
        const double z = (shot.is_complete ? 1 : -1) * (shot.speed - v50) / sigma;
        sum -= 2 * std::log(0.5 * std::erfc(-z / std::sqrt(2.0)));
    }
    return sum;
}

TEST(Fit, GivesThePublishedEstimatesOfTheProbitModel) {
    const auto found = fit_of(nine_shots());
    EXPECT_NEAR(found.response.v50, 11.1611, 5e-5);  // all digits that are printed
    EXPECT_NEAR(found.response.sigma, 0.4115, 5e-5);
}

TEST(Fit, MeetsTheSharesOfTwoSpeeds) {
    const auto normal = fit_of(two_speeds());
    EXPECT_NEAR(normal.response.v50, 150, 1e-9);
    EXPECT_NEAR(normal.response.sigma, 50 / 0.6744897501960817, 1e-9);  // quantile of 3/4
    const auto logistic = fit_of(two_speeds(), Distribution::logistic);
    EXPECT_NEAR(logistic.response.v50, 150, 1e-9);
    EXPECT_NEAR(logistic.response.sigma, 50 / std::log(3.0) * std::numbers::pi / std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(logistic.log_likelihood, 8 * (0.75 * std::log(0.75) + 0.25 * std::log(0.25)), 1e-12);
}

TEST(Fit, HasQuantilesOfItsCurve) {
    const auto found = fit_of(twenty_shots());
    EXPECT_NEAR(found.speed_at(0.95).value, found.response.v50 + 1.6448536269514722 * found.response.sigma,
                1e-9);
    EXPECT_DOUBLE_EQ(found.speed_at(0.5).value, found.response.v50);
}

/// At the end of an interval the best curve of that median loses the deviance that is allowed: no curve of
/// a fine grid of deviations loses less, and one loses hardly more.
TEST(Fit, EndsItsIntervalsAtTheAllowedDeviance) {
    const auto shots = twenty_shots();
    const auto found = fit_of(shots);
    const double least = deviance(shots, found.response.v50, found.response.sigma);
    ASSERT_TRUE(found.speed_at(0.5).lower && found.speed_at(0.5).upper);
    for (const double end : {*found.speed_at(0.5).lower, *found.speed_at(0.5).upper}) {
        double best = std::numeric_limits<double>::infinity();
        for (double sigma = 1; sigma < 200; sigma *= 1.0005)
            best = std::min(best, deviance(shots, end, sigma));
        EXPECT_NEAR(best - least, allowed_deviance, 1e-5);  // the grid misses the best by (0.0005)^2 times 20
    }
    ASSERT_TRUE(found.sigma.lower && found.sigma.upper);
    for (const double end : {*found.sigma.lower, *found.sigma.upper}) {
        double best = std::numeric_limits<double>::infinity();
        for (double v50 = 350; v50 < 450; v50 += 0.005) best = std::min(best, deviance(shots, v50, end));
        EXPECT_NEAR(best - least, allowed_deviance, 1e-5);
    }
}

TEST(Fit, IsThatOfShotsInAnotherUnit) {
    auto in_feet = twenty_shots();
    for (Shot& shot : in_feet) shot.speed /= 0.3048;
    const auto metres = fit_of(twenty_shots()), feet = fit_of(in_feet);
    EXPECT_NEAR(feet.speed_at(0.05).lower.value() * 0.3048, metres.speed_at(0.05).lower.value(), 1e-6);
    EXPECT_NEAR(feet.sigma.upper.value() * 0.3048, metres.sigma.upper.value(), 1e-6);
}

/// Eight shots do not exclude that speed has no influence: then no speed excludes any probability.
TEST(Fit, LeavesIntervalsOpenThatTheShotsDoNotClose) {
    const auto found = fit_of(two_speeds());
    EXPECT_FALSE(found.sigma.upper);
    EXPECT_TRUE(found.sigma.lower);
    EXPECT_FALSE(found.speed_at(0.5).lower);
    EXPECT_FALSE(found.speed_at(0.5).upper);
    EXPECT_FALSE(found.speed_at(0.05).lower);
    EXPECT_FALSE(found.speed_at(0.95).upper);
    EXPECT_TRUE(fit_of(two_speeds(), Distribution::normal, 0.5).speed_at(0.5).lower);
}

TEST(Fit, IsRefusedWithoutAZoneOfMixedResults) {
    const std::vector<Shot> apart{{100, false}, {150, false}, {160, true}};
    EXPECT_EQ(std::get<std::string>(fit(apart, Distribution::normal, probabilities, 0.95)),
              "no fit: no zone of mixed results, the highest partial penetration, 150.00 m/s, lies below the "
              "lowest complete one, 160.00 m/s");
    const std::vector<Shot> alike{{100, true}, {150, true}};
    EXPECT_EQ(std::get<std::string>(fit(alike, Distribution::normal, probabilities, 0.95)),
              "no fit: 2 shots, all of them complete penetrations");
}

TEST(Fit, IsRefusedWhereTheShareFallsWithSpeed) {
    const std::vector<Shot> falling{{100, true}, {150, false}, {200, true}, {250, false}};
    EXPECT_EQ(std::get<std::string>(fit(falling, Distribution::logistic, probabilities, 0.95)),
              "no fit: the share of complete penetrations does not rise with speed");
}

TEST(LogProbability, IsContinuousWhereItsFormChanges) {
    const auto above = log_probability(Distribution::normal, -35 + 1e-9),
               below = log_probability(Distribution::normal, -35 - 1e-9);
    EXPECT_NEAR(above.value, below.value, 1e-6);  // slope of 35 over 2e-9, and rounding of 6e2
    EXPECT_NEAR(above.slope, below.slope, 1e-6);
    EXPECT_TRUE(std::isfinite(log_probability(Distribution::normal, -1e6).value));
}

TEST(LogProbability, HasTheDerivativesOfItsValue) {
    for (const auto distribution : {Distribution::normal, Distribution::logistic})
        for (const double z : {-40.0, -3.0, 0.0, 2.0}) {
            constexpr double h = 1e-5;
            const auto at = log_probability(distribution, z), up = log_probability(distribution, z + h),
                       down = log_probability(distribution, z - h);
            EXPECT_NEAR(at.slope, (up.value - down.value) / (2 * h), 1e-6 * (1 + std::abs(at.slope)));
            EXPECT_NEAR(at.curvature, (up.slope - down.slope) / (2 * h), 1e-6);
        }
}

}  // namespace
}  // namespace weavefront::ballistics
