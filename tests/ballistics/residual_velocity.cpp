#include "weavefront/ballistics/residual_velocity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace weavefront::ballistics {
namespace {

std::vector<Perforation> on_curve(double v50, double a, double p) {
    std::vector<Perforation> shots;
    for (const double speed : {310.0, 330.0, 350.0, 400.0, 500.0, 700.0})
        shots.push_back({speed, a * std::pow(std::pow(speed, p) - std::pow(v50, p), 1 / p)});
    return shots;
}

TEST(RechtIpson, ReturnsTheLimitOfItsOwnCurve) {
    const auto curve = fit_recht_ipson(on_curve(300, 1, 2));
    ASSERT_TRUE(curve);
    EXPECT_NEAR(curve->v50, 300, 1e-4);
    EXPECT_NEAR(curve->deviation, 0, 1e-4);
    EXPECT_NEAR(curve->residual(500), 400, 1e-3);
    EXPECT_EQ(curve->residual(299), 0);
}

TEST(RechtIpson, NeedsAShotThatWentThrough) {
    EXPECT_FALSE(fit_recht_ipson({}));
    const std::vector<Perforation> one{{500, 400}};
    EXPECT_NEAR(fit_recht_ipson(one)->v50, 300, 1e-4);
}

TEST(LambertJonas, ReturnsTheConstantsOfItsOwnCurve) {
    const auto curve = fit_lambert_jonas(on_curve(300, 0.8, 2.6));
    ASSERT_TRUE(curve);
    EXPECT_NEAR(curve->v50, 300, 0.05);
    EXPECT_NEAR(curve->a, 0.8, 1e-3);
    EXPECT_NEAR(curve->p, 2.6, 0.01);
}

TEST(LambertJonas, NeedsFourSpeeds) {
    auto shots = on_curve(300, 1, 2);
    shots.resize(3);
    shots.push_back(shots.back());
    EXPECT_FALSE(fit_lambert_jonas(shots));
}

}  // namespace
}  // namespace weavefront::ballistics
