#include "weavefront/simd/math.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace weavefront::simd {
namespace {

/// Error in units of the last place of the exact value.
double ulps(double value, long double exact) {
    const double spacing =
        std::nextafter(std::abs(static_cast<double>(exact)), INFINITY) - std::abs(static_cast<double>(exact));
    return static_cast<double>(std::abs(static_cast<long double>(value) - exact) /
                               static_cast<long double>(spacing));
}

TEST(Math, AtanIsWithinTwoUnitsOfTheLastPlace) {
    double worst = 0;
    for (int i = -100000; i <= 100000; ++i) {
        const double x = i / 100000.0;
        if (i != 0) worst = std::max(worst, ulps(atan(x), std::atan(static_cast<long double>(x))));
    }
    EXPECT_LT(worst, 2.0);
    EXPECT_EQ(atan(0.0), 0.0);
    EXPECT_EQ(atan(1.0), std::numbers::pi / 4);
}

TEST(Math, LogarithmOfARatio) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-60, 60), near(-1e-3, 1e-3), fraction(0.5, 2);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double b = std::exp(exponent(random));
        for (const double a : {b * (1 + near(random)), b * fraction(random), std::exp(exponent(random))}) {
            const long double A = a, B = b;
            const long double exact = std::abs(A - B) < B / 2 ? std::log1p((A - B) / B) : std::log(A / B);
            if (a != b) worst = std::max(worst, ulps(log_ratio(a, b), exact));
        }
    }
    // difference, sum and quotient of u round to 1.5 units together; the series, or the quotient a/b of the
    // long way, adds about 2
    EXPECT_LT(worst, 4.0);
}

TEST(Math, RelaxationFromInstantToForever) {
    for (double a = 1e-18; a < 1e12; a *= 1.37) {
        // y (2 - y) does not amplify errors; each of up to ten doublings adds one rounding of about 2 units
        EXPECT_LT(ulps(one_minus_exp(a), -std::expm1(-static_cast<long double>(a))), 24) << a;
    }
    EXPECT_EQ(one_minus_exp(0), 0);
    EXPECT_EQ(one_minus_exp(1e12), 1);
}

TEST(Math, ExponentialOfAnySize) {
    // 1 + sum rounds once, and the product of k and ln 2 leaves 1e-17 of r
    for (double a = -700; a <= 700; a += 0.37)
        EXPECT_LT(ulps(exponential(a), std::exp(static_cast<long double>(a))), 2) << a;
    EXPECT_EQ(exponential(0), 1);
}

TEST(Math, LogarithmOfTheGammaFunction) {
    // ln Gamma(z + 12) and the logarithm of the product, of up to 22, round by 4 units each
    for (double z = 1; z <= 2; z += 1e-3) EXPECT_NEAR(log_gamma(z), std::lgamma(z), 1e-13) << z;
}

TEST(Math, Sine) {
    for (double a = 0.01; a < 1.5708; a += 0.01)
        EXPECT_LT(ulps(sine(a), std::sin(static_cast<long double>(a))), 3) << a;
}

TEST(Math, ClampKeepsWhatIsNotANumber) {
    EXPECT_TRUE(std::isnan(clamp(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0)));
    EXPECT_EQ(clamp(2.0, 0.0, 1.0), 1.0);
    EXPECT_EQ(clamp(-2.0, 0.0, 1.0), 0.0);
}

}  // namespace
}  // namespace weavefront::simd
