/// The hysteretic penalty law.

#include "weavefront/contact/penalty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace weavefront::test {
namespace {

using contact::PenaltyLaw;
using contact::Penetration;

constexpr double k = 5e12, u = 10, G = 1e-4;

PenaltyLaw plain() { return {{.stiffness = k, .unloading = u, .damping = 0}, 0.2}; }

/// Sides that move along the force only.
contact::RelativeMotion straight(double closing) { return {closing, closing, std::abs(closing)}; }

/// A facet of one point that has no energy to spend on recovery.
double advance(const PenaltyLaw& law, Penetration& point, double geometric, double closing, double dt) {
    return law.advance(point, geometric, straight(closing), dt, 1, {}).pressure;
}

/// Moves a point from its penetration to `to` in `steps` equal steps of 1 s; returns the last pressure and
/// adds to the work done on it.
double move(const PenaltyLaw& law, Penetration& point, double& at, double to, int steps,
            double* work = nullptr, double* last = nullptr) {
    double pressure = last ? *last : 0;
    const double step = (to - at) / steps;
    for (int i = 1; i <= steps; ++i) {
        const double before = pressure;
        at += step;
        pressure = advance(law, point, at, step, 1);
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
        const double pressure = advance(law, point, G * one(random), closing, 1e-7);
        ASSERT_GE(pressure, 0);
        ASSERT_GE(point.present(), 0);
        ASSERT_LE(point.present(), G);
    }
}

TEST(PenaltyLaw, IgnoresAnOverlapThatMotionDidNotCause) {
    const auto law = plain();
    Penetration point;
    double g = G;
    EXPECT_EQ(advance(law, point, G, 0, 1), 0);                              // found late
    EXPECT_NEAR(move(law, point, g, 1.25 * G, 5), k * G / 4, 1e-9 * k * G);  // but it resists going on
    EXPECT_EQ(move(law, point, g, 0.75 * G, 5), 0);                          // nothing is pushed out
    EXPECT_NEAR(move(law, point, g, 0.85 * G, 5), k * G / 10,
                1e-9 * k * G);  // it is ignored no farther than the sides stay in
    EXPECT_NEAR(advance(law, point, 2 * G, G / 100, 1), k * (G / 10 + G / 100),
                1e-9 * k * G);  // a facet has changed
    EXPECT_EQ(advance(law, point, 0.85 * G, -2 * G, 1), 0);
}

/// Motion of a side that slides while the overlap changes.
contact::RelativeMotion sliding(double rate) { return {0, 0, rate}; }

TEST(PenaltyLaw, SlidingChangesThePressureAlongTheLoadingSlopeWhateverTheOpening) {
    const auto law = plain();
    Penetration point;
    double g = 0;
    move(law, point, g, G, 10);
    const double opened = 0.05 * G, pressure = move(law, point, g, G - opened, 10);
    const auto slide = [&](double to) {
        const auto response = law.advance(point, to, sliding(G), 1, 1, {});
        return response;
    };
    const auto away = slide(0.8 * G), back = slide(G - opened);
    EXPECT_NEAR(away.pressure, pressure - k * (G - opened - 0.8 * G), 1e-9 * k * G);
    EXPECT_NEAR(back.pressure, pressure, 1e-9 * k * G);
    // What it gives up on the way is what it takes on the way back: p^2/(2 u k) of both.
    const double energy = (pressure * pressure - away.pressure * away.pressure) / (2 * u * k);
    EXPECT_NEAR(away.sliding.released, energy, 1e-9 * energy);
    EXPECT_NEAR(back.sliding.taken, energy, 1e-9 * energy);
    EXPECT_EQ(away.sliding.taken, 0);
    EXPECT_EQ(back.sliding.released, 0);
    // Once nothing presses any more, what slides in presses at once.
    EXPECT_EQ(move(law, point, g, 0.5 * G, 10), 0);
    EXPECT_NEAR(slide(0.7 * G).pressure, 0.2 * k * G, 1e-9 * k * G);
}

TEST(PenaltyLaw, SlidingTakesOnlyTheAllowedShare) {
    const auto law = plain();
    for (const double share : {0.0, 0.25, 1.0}) {
        Penetration point;
        const auto response =
            law.advance(point, G, sliding(G), 1, 0.5, {.dissipated_budget = 0, .sliding_share = share});
        EXPECT_NEAR(response.pressure, share * k * G, 1e-9 * k * G);
        EXPECT_NEAR(response.sliding.wanted, 0.5 * k * G * G / (2 * u), 1e-9 * k * G * G);
        EXPECT_NEAR(response.sliding.taken, 0.5 * share * share * k * G * G / (2 * u), 1e-9 * k * G * G);
        EXPECT_NEAR(point.ignored, (1 - share) * G, 1e-12 * G);
    }
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

/// Two plies that overlap, seen from their common centre of mass.
struct Overlap {
    double mass, g, dissipated_budget;  // kg/m2, m, J/m2
    double closing = 0;                 // m/s
    Penetration point{};

    /// Advances by `time` in steps of `dt`, s; returns the largest closing or opening speed.
    double run(const PenaltyLaw& law, double time, double dt) {
        double fastest = 0;
        for (double t = 0; t < time; t += dt) {
            const auto response =
                law.advance(point, g, straight(closing), dt, 1, {.dissipated_budget = dissipated_budget});
            const double pressure = response.pressure;
            dissipated_budget += response.dissipated;
            closing -= pressure / mass * dt;
            g += closing * dt;
            fastest = std::max(fastest, std::abs(closing));
        }
        return fastest;
    }
};

TEST(PenaltyLaw, RecoversAnIgnoredOverlapFromTheDissipatedBudget) {
    const double mass = 0.1, omega = std::sqrt(u * k / mass), period = 2 * std::numbers::pi / omega;
    const PenaltyLaw law({.stiffness = k, .unloading = u, .damping = 0}, mass);
    const double given_at_once = k * G * G / 2;
    Overlap rich{.mass = mass, .g = G, .dissipated_budget = given_at_once};
    const double fastest = rich.run(law, 1000 * period, 0.05 * period);
    EXPECT_LT(rich.g, 0.05 * G);
    // Elastic contact would throw the plies apart with omega G/sqrt(u); recovery leaves an order of G in a
    // hundred periods.
    EXPECT_LT(fastest, 2 * G / (100 * period));
    // What they fly apart with is missing from the dissipated_budget.
    EXPECT_GE(rich.dissipated_budget, 0);
    EXPECT_LE(mass * rich.closing * rich.closing / 2, given_at_once - rich.dissipated_budget);

    Overlap poor{.mass = mass, .g = G, .dissipated_budget = 0};
    EXPECT_EQ(poor.run(law, 1000 * period, 0.05 * period), 0);
    EXPECT_EQ(poor.g, G);

    const PenaltyLaw elastic({.stiffness = k, .unloading = 1, .damping = 0.2}, mass);
    Overlap kept{.mass = mass, .g = G, .dissipated_budget = given_at_once};
    EXPECT_EQ(kept.run(elastic, 1000 * period, 0.05 * period), 0);
}

TEST(PenaltyLaw, CreatesNoEnergyWhateverTheGeometry) {
    const double mass = 0.1, omega = std::sqrt(u * k / mass), dt = 0.01 / omega;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> one(-1, 1);
    for (const double damping : {0.0, 0.2}) {
        const PenaltyLaw law({.stiffness = k, .unloading = u, .damping = damping}, mass);
        double recovered = 0;
        for (int path = 0; path < 200; ++path) {
            Penetration point;
            double g = 0, dissipated_budget = 0, work = 0, pressure = 0, closing = 0;
            for (int n = 0; n < 5000; ++n) {
                if (n % 50 == 0) closing = 0.01 * G * one(random) / dt;
                if (n % 500 == 0) g += G * one(random);  // an element disappears, a facet changes
                g += closing * dt;
                const auto response =
                    law.advance(point, g, straight(closing), dt, 1,
                                {.dissipated_budget = dissipated_budget, .sliding_share = 0});
                work += (pressure + response.pressure) / 2 * closing * dt;
                pressure = response.pressure;
                dissipated_budget += response.dissipated;
                recovered += std::max(-response.dissipated, 0.0);
                const double step =
                    u * k * 0.01 * G * 0.01 * G;  // what a step over the corner of a line may give
                ASSERT_GE(dissipated_budget, -step);
                ASSERT_GE(work, -step) << path << ' ' << n;
            }
        }
        EXPECT_GT(recovered, 0);
    }
}

/// Leaving over arriving speed of a free mass on the law, `steps` to the radian of its loading frequency.
double restitution(double unloading, double steps) {
    const double mass = 0.2, omega = std::sqrt(k / mass), dt = 1 / (omega * steps);
    const PenaltyLaw law({.stiffness = k, .unloading = unloading, .damping = 0}, mass);
    Penetration point;
    double g = -0.3 * dt, v = 1;
    do {
        g += v * dt;
        v -= advance(law, point, g, v, dt) / mass * dt;
    } while (g > 0);
    return -v;
}

TEST(PenaltyLaw, AFreeMassBouncesWithTheRootOfTheSlopes) {
    for (const double unloading : {1.0, 4.0, 10.0}) {
        const double closed = 1 / std::sqrt(unloading);
        const double coarse = std::abs(restitution(unloading, 50) - closed),
                     fine = std::abs(restitution(unloading, 800) - closed);
        // first order: of one step of unloading, sqrt(u)/steps of a radian, the part in which the line is
        // first or last crossed
        EXPECT_LT(coarse, std::sqrt(unloading) / 50) << unloading;
        EXPECT_LT(fine, std::sqrt(unloading) / 800) << unloading;
    }
}

TEST(PenaltyLaw, DampsAFractionOfCritical) {
    const double density = 0.2, fraction = 0.3, speed = 5, dt = 1e-7;
    const PenaltyLaw law({.stiffness = k, .unloading = 1, .damping = fraction}, density);
    Penetration point;
    const double pressure = advance(law, point, speed * dt, speed, dt);
    EXPECT_NEAR(pressure, k * speed * dt + 2 * fraction * std::sqrt(k * density) * speed, 1e-12 * pressure);
}

TEST(PenaltyLaw, PointsOfABatchAdvanceLikeSingleOnes) {
    const PenaltyLaw law({.stiffness = k, .unloading = u, .damping = 0.2}, 0.1);
    std::mt19937_64 random(21);
    const auto random_number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    contact::PenetrationLanes points;
    std::array<Penetration, contact::batch_width> one_by_one{};
    double dissipated_budget = 0;
    int slid = 0;
    for (int step = 0; step < 300; ++step) {
        contact::Lanes geometric, share;
        contact::RelativeMotionLanes motion;
        contact::LaneMask met;
        const contact::Surroundings around{dissipated_budget, random_number(0, 1)};
        for (std::size_t i = 0; i < contact::batch_width; ++i) {
            geometric[i] = random_number(-G / 4, G), motion.closing[i] = random_number(-50, 50),
            share[i] = 0.125;
            motion.most[i] = random_number(0, 200);
            met[i] = random_number(0, 1) < 0.8;
        }
        contact::ContactResponse sum, expected;
        const auto pressure = law.advance(points, met, geometric, motion, 1e-7, share, around, sum);
        for (std::size_t i = 0; i < contact::batch_width; ++i) {
            if (met[i]) {
                const contact::RelativeMotion of_point{motion.closing[i], motion.closing[i], motion.most[i]};
                const auto response =
                    law.advance(one_by_one[i], geometric[i], of_point, 1e-7, share[i], around);
                ASSERT_EQ(pressure[i], response.pressure);
                expected.dissipated += response.dissipated;
                expected.sliding.add(response.sliding);
            } else {
                ASSERT_EQ(pressure[i], 0);
            }
            ASSERT_EQ(points.overlap[i], one_by_one[i].overlap);
            ASSERT_EQ(points.ignored[i], one_by_one[i].ignored);
            ASSERT_EQ(points.opened[i], one_by_one[i].opened);
        }
        ASSERT_EQ(sum.dissipated, expected.dissipated);
        ASSERT_EQ(sum.sliding.released, expected.sliding.released);
        ASSERT_EQ(sum.sliding.taken, expected.sliding.taken);
        ASSERT_EQ(sum.sliding.wanted, expected.sliding.wanted);
        slid += sum.sliding.taken > 0;
        dissipated_budget += sum.dissipated;
    }
    EXPECT_GT(slid, 0);
}

// What the points of a facet that is seen mirrored or turned do: the same, in another order.
TEST(PenaltyLaw, RecoveryDoesNotDependOnTheOrderOfPoints) {
    const PenaltyLaw law({.stiffness = k, .unloading = u, .damping = 0}, 0.1);
    const auto heal = [&](bool backwards) {
        contact::PenetrationLanes points;
        double dissipated_budget = 1e-3 * k * G * G;  // for a few points
        for (int step = 0; step < 1000; ++step) {
            contact::Lanes geometric, share;
            contact::LaneMask met;
            met.fill(true);
            for (std::size_t i = 0; i < contact::batch_width; ++i) {
                const std::size_t place = backwards ? contact::batch_width - 1 - i : i;
                geometric[place] = G * static_cast<double>(1 + i), share[place] = 0.125;
            }
            contact::ContactResponse sum;
            const auto pressure = law.advance(points, met, geometric, {}, 1e-7, share,
                                              {.dissipated_budget = dissipated_budget}, sum);
            EXPECT_GE(dissipated_budget += sum.dissipated, -1e-12 * k * G * G);
            static_cast<void>(pressure);
        }
        std::array<double, contact::batch_width> present;
        for (std::size_t i = 0; i < contact::batch_width; ++i)
            present[i] = points.overlap[i] - points.ignored[i];
        if (backwards) std::ranges::reverse(present);
        return present;
    };
    const auto one = heal(false), other = heal(true);
    for (std::size_t i = 0; i < contact::batch_width; ++i) {
        EXPECT_GT(one[i], 0) << i;
        EXPECT_LT(one[i], G * static_cast<double>(1 + i)) << i;
        EXPECT_NEAR(other[i], one[i], 1e-12 * one[i]) << i;
    }
}

}  // namespace
}  // namespace weavefront::test
