#include "weavefront/study/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "weavefront/study/strip.hpp"

namespace weavefront::study {
namespace {

TEST(ConstantRateStress, IsInstantaneousAtFirstAndStaticAtLast) {
    const double E1 = 96e9, Ka = 192e9, tau = 1e-4;
    EXPECT_NEAR(constant_rate_stress(E1, Ka, tau, 1, 1e-9) / (Ka * 1e-9), 1, 1e-5);
    EXPECT_NEAR(constant_rate_stress(E1, Ka, tau, 1, 100) / (E1 * 100), 1, 1e-5);
    EXPECT_DOUBLE_EQ(constant_rate_stress(E1, Ka, 0, 2, 3), E1 * 6);
}

TEST(SmithImpact, SatisfiesItsEquations) {
    const double V = 200, c = 8000;
    const SmithImpact impact = smith_impact(V, c);
    const double e = impact.strain, root = std::sqrt(e * (1 + e));
    EXPECT_NEAR(c * std::sqrt(2 * e * root - e * e), V, 1e-9 * V);
    EXPECT_NEAR(impact.transverse_speed, c * (root - e), 1e-9 * c);
}

TEST(StripWaves, AreThoseOfAnIdealImpact) {
    const double U = 700, c = 8000, strain = 0.007, V = 200, size = 0.25e-3;
    std::vector<StripFrame> frames;
    for (int k = 0; k <= 10; ++k) {
        StripFrame frame{.time = k * 4e-6, .x = {}, .z = {}, .centre = {}, .strain = {}};
        for (int i = 0; i < 2000; ++i) {
            const double x = i * size;
            frame.x.push_back(x);
            frame.z.push_back(std::max(0.0, V * frame.time - V / U * x));
            frame.centre.push_back(x + size / 2);
            const bool under_projectile = x < U * frame.time / 2;  // left out of the plateau
            frame.strain.push_back(x + size / 2 < c * frame.time ? (under_projectile ? 2 : 1) * strain : 0);
        }
        frames.push_back(frame);
    }
    const StripWaves waves = measure_strip(frames, strain);
    EXPECT_NEAR(waves.strain, strain, 1e-9);
    EXPECT_NEAR(waves.transverse_speed, U, 1e-6 * U);
    // The front is found to within half an element at both ends of a fit over 30 us.
    EXPECT_NEAR(waves.longitudinal_speed, c, size / 30e-6);
}

}  // namespace
}  // namespace weavefront::study
