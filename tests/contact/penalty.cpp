/// The hysteretic penalty law.

#include "weavefront/contact/penalty.hpp"

#include <gtest/gtest.h>

#include <random>

namespace weavefront::test {
namespace {

using contact::PenaltyLaw;
using contact::Penetration;

constexpr double k = 5e12, u = 10, G = 1e-4;

PenaltyLaw plain() { return {{.stiffness = k, .unloading = u, .damping = 0}, 0.2}; }

/// Moves a point from its penetration to `to` in `steps` equal steps of 1 s; returns the last pressure and adds to the work done on it.
double move(const PenaltyLaw& law, Penetration& point, double& at, double to, int steps, double* work = nullptr, double* last = nullptr) {
    double pressure = last ? *last : 0;
    const double step = (to - at) / steps;
    for (int i = 1; i <= steps; ++i) {
        const double before = pressure;
        at += step;
        pressure = law.advance(point, at, step, 1);
        if (work) *work += (before + pressure) / 2 * step;
    }
    if (last) *last = pressure;
    return pressure;
}

TEST(PenaltyLaw, LoadsUnloadsAndReloadsAlongItsLines) {
    const auto law = plain();
    Penetration point;
    double g = 0;
    EXPECT_NEAR(move(law, point, g, G / 2, 10), k * G / 2, 1e-10 * k * G);
    EXPECT_NEAR(move(law, point, g, G, 10), k * G, 1e-10 * k * G);
    const double residual = G * (1 - 1 / u);
    for (const double part : {0.75, 0.5, 0.25})
        EXPECT_NEAR(move(law, point, g, residual + part * (G - residual), 3), part * k * G, 1e-9 * k * G);
    EXPECT_EQ(move(law, point, g, residual * 0.99, 3), 0);
    EXPECT_EQ(move(law, point, g, residual * 0.1, 3), 0);
    EXPECT_NEAR(move(law, point, g, residual + 0.5 * (G - residual), 3), 0.5 * k * G, 1e-9 * k * G);
    EXPECT_NEAR(move(law, point, g, 1.5 * G, 9), 1.5 * k * G, 1e-9 * k * G);
}

TEST(PenaltyLaw, ForgetsWhenApart) {
    const auto law = plain();
    Penetration point;
    double g = 0;
    move(law, point, g, G, 10);
    move(law, point, g, -G, 10);
    g = 0;
    EXPECT_NEAR(move(law, point, g, G / 10, 10), k * G / 10, 1e-10 * k * G);
}

TEST(PenaltyLaw, IsNeverTensile) {
    const PenaltyLaw law({.stiffness = k, .unloading = u, .damping = 0.5}, 0.2);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> one(-1, 1);
    Penetration point;
    for (int n = 0; n < 10000; ++n) {
        const double closing = 100 * one(random);
        const double pressure = law.advance(point, G * one(random), closing, 1e-7);
        ASSERT_GE(pressure, 0);
        ASSERT_LE(point.present, G);
    }
}

TEST(PenaltyLaw, AnOverlapThatWasNotMadeByMotionPushesNothing) {
    const auto law = plain();
    Penetration point;
    EXPECT_EQ(law.advance(point, G, 0, 1), 0);  // found late
    EXPECT_EQ(law.advance(point, G, -1, 1), 0);
    EXPECT_NEAR(law.advance(point, G, G / 4, 1), k * G / 4, 1e-12 * k * G);                             // but resists going on
    EXPECT_NEAR(law.advance(point, G / 8, 0, 1), k * std::max(0.0, G / 4 - u * G / 8), 1e-12 * k * G);  // and follows the geometry back
}

TEST(PenaltyLaw, AClosedCycleTakesTheAreaBetweenTheLines) {
    const auto law = plain();
    Penetration point;
    double g = 0, work = 0, pressure = 0;
    const auto to = [&](double target) { move(law, point, g, target, 100, &work, &pressure); };
    to(G);
    EXPECT_NEAR(work, k * G * G / 2, 1e-10 * k * G * G);
    to(G * (1 - 1 / u));
    to(0);
    const double cycle = (1 - 1 / u) * k * G * G / 2;
    EXPECT_NEAR(work / cycle, 1, 1e-10);
    // going in again along the unloading line takes only what comes back
    to(G);
    to(G * (1 - 1 / u));
    EXPECT_NEAR(work / cycle, 1, 1e-10);
    // but once apart the point loads afresh
    to(0);
    to(-G);
    to(0);
    to(G);
    EXPECT_NEAR((work - cycle) / (k * G * G / 2), 1, 1e-10);
}

/// Leaving over arriving speed of a free mass on the law, `steps` to the radian of its loading frequency.
double restitution(double unloading, double steps) {
    const double mass = 0.2, omega = std::sqrt(k / mass), dt = 1 / (omega * steps);
    const PenaltyLaw law({.stiffness = k, .unloading = unloading, .damping = 0}, mass);
    Penetration point;
    double g = -0.3 * dt, v = 1;
    do {
        g += v * dt;
        v -= law.advance(point, g, v, dt) / mass * dt;
    } while (g > 0);
    return -v;
}

TEST(PenaltyLaw, AFreeMassBouncesWithTheRootOfTheSlopes) {
    for (const double unloading : {1.0, 4.0, 10.0}) {
        const double closed = 1 / std::sqrt(unloading);
        const double coarse = std::abs(restitution(unloading, 50) - closed), fine = std::abs(restitution(unloading, 800) - closed);
        // first order: of one step of unloading, sqrt(u)/steps of a radian, the part in which the line is first or last crossed
        EXPECT_LT(coarse, std::sqrt(unloading) / 50) << unloading;
        EXPECT_LT(fine, std::sqrt(unloading) / 800) << unloading;
    }
}

TEST(PenaltyLaw, DampsAFractionOfCritical) {
    const double density = 0.2, fraction = 0.3, speed = 5, dt = 1e-7;
    const PenaltyLaw law({.stiffness = k, .unloading = 1, .damping = fraction}, density);
    Penetration point;
    const double pressure = law.advance(point, speed * dt, speed, dt);
    EXPECT_NEAR(pressure, k * speed * dt + 2 * fraction * std::sqrt(k * density) * speed, 1e-12 * pressure);
}

}  // namespace
}  // namespace weavefront::test
