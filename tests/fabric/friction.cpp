/// Yarn-on-yarn friction.

#include "weavefront/fabric/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "material_point.hpp"

namespace weavefront::test {
namespace {

constexpr fabric::Features rubbing{.formulation = consistent, .crimp = true, .friction = true};
constexpr fabric::Features rubbing_paper{.formulation = paper, .crimp = true, .friction = true};

/// Integral of the distance from the centre over the rhombus of two strips of width w that cross at 2 theta,
/// over its area. In polar coordinates each triangle between centre and side contributes the integral of
/// r^3/3 over its angle; all sides are w/2 away.
double arm_by_quadrature(double w, double theta) {
    // half the side pointing from the foot of the perpendicular to either corner, seen under pi/2 - theta and
    // theta
    const auto wedge = [w](double angle) {
        const int n = 20000;
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += 1 / std::pow(std::cos((i + 0.5) * angle / n), 3);
        return sum * angle / n * std::pow(w / 2, 3) / 3;
    };
    const double integral = 4 * (wedge(theta) + wedge(90 * degree - theta));
    return integral / (w * w / std::sin(2 * theta));
}

TEST(Friction, ArmIsTheMeanDistanceInTheRhombus) {
    const fabric::Constants c = fabric::constants_of(kevlar129());
    for (double theta = 12; theta < 80; theta += 4) {
        const double arm = fabric::friction_arm<rubbing>(c, fabric::trellis_of(std::cos(2 * theta * degree)));
        // midpoint rule with 20000 points: its error is below 1e-6 at these angles
        EXPECT_NEAR(arm / arm_by_quadrature(c.fill.width, theta * degree), 1, 1e-6) << theta;
        EXPECT_NEAR(arm,
                    fabric::friction_arm<rubbing>(c, fabric::trellis_of(std::cos(2 * (90 - theta) * degree))),
                    1e-14 * arm);
    }
}

TEST(Friction, ArmStaysAtItsLockingValueBeyondLocking) {
    const fabric::Constants c = fabric::constants_of(kevlar129());
    const double locked = fabric::friction_arm<rubbing>(c, fabric::trellis_of(std::cos(20 * degree)));
    EXPECT_NEAR(fabric::friction_arm<rubbing>(c, fabric::trellis_of(std::cos(2 * degree))), locked,
                1e-13 * locked);
    EXPECT_NEAR(fabric::friction_arm<rubbing>(c, fabric::trellis_of(-1.0)), locked, 1e-13 * locked);
    scene::Fabric flat = kevlar129();
    flat.lateral->locking_angle = 45 * degree;
    EXPECT_TRUE(
        std::isfinite(fabric::friction_arm<rubbing>(fabric::constants_of(flat), fabric::trellis_of(1.0))));
}

TEST(Friction, WithoutALockingAngleTheWidthLimitsTheArm) {
    scene::Fabric fabric = kevlar129();
    fabric.lateral.reset();
    const fabric::Constants c = fabric::constants_of(fabric);
    // sin(2 theta_min) = w/s (1)
    EXPECT_NEAR(c.packed_cos_2theta, std::cos(std::asin(0.32 / 0.909)), 1e-15);
}

struct Spent {
    double work, expected;
    double first;  ///< the first step's part of `expected`
};

/// Turns a stretched trellis from 45 deg by `degrees` and back; the work of friction against its closed form.
template <fabric::Features F>
Spent turn(int degrees, int steps_per_degree) {
    scene::Fabric fabric = elastic_kevlar129();
    fabric.lateral.reset();
    MaterialPoint<F> point(fabric, 1e-9);
    const fabric::Constants& c = point.constants;
    const double lambda = 1.02;
    point.advance({.lambda_f = lambda, .lambda_w = lambda});
    const double length = std::hypot(lambda * c.fill.span / 2, c.thickness / 4);
    const double F_f = c.fill.static_modulus * (length / c.fill.length - 1) * c.fill.area * c.thickness / 4 /
                       length;  // equibiaxial: known
    const double before = point.state.friction_work;
    double expected = 0, first = 0;
    const double dtheta = degree / steps_per_degree;
    for (int i = 1; i <= degrees * steps_per_degree; ++i) {
        const double theta = 45 * degree + i * dtheta, middle = theta - dtheta / 2;
        point.advance({.lambda_f = lambda, .lambda_w = lambda, .theta = theta});
        const double M = 2 * c.friction * F_f * arm_by_quadrature(c.fill.width, middle);
        const double s = std::sin(middle), co = std::cos(middle);
        const double per_radian =
            F.paper() ? lambda * lambda * std::sin(2 * middle) * (s * s / co + co * co / s) : 1.0;
        expected += 2 * M * per_radian * dtheta / (c.fill.span * c.fill.span);
        if (i == 1) first = expected;
    }
    return {point.state.friction_work - before, expected, first};
}

TEST(Friction, PureTrellisDissipatesTwiceTheMomentPerCell) {
    const Spent spent = turn<rubbing>(20, 20);
    // while the yarns stick, over the first 1e-3 rad, half of M is missing; a step is 8.7e-4 rad, which blurs
    // this by as much again
    const double missing = 0.5 * spent.first / spent.expected * fabric::stick_angle / (degree / 20);
    EXPECT_NEAR(spent.work / spent.expected, 1 - missing, missing);
}

TEST(Friction, PureTrellisAsPrinted) {
    const Spent spent = turn<rubbing_paper>(20, 20);
    // (46),(47) act from the first step on at full size; the trapezoid begins at zero: half of the first step
    // is missing
    EXPECT_NEAR(spent.work / spent.expected, 1 - 0.5 * spent.first / spent.expected, 2e-6);
}

TEST(Friction, YarnsStickBelowTheStickAngle) {
    scene::Fabric fabric = elastic_kevlar129();
    MaterialPoint<rubbing> point(fabric, 1e-9);
    point.advance({.lambda_f = 1.02, .lambda_w = 1.02});
    for (int i = 0; i <= 100; ++i)
        point.advance({.lambda_f = 1.02,
                       .lambda_w = 1.02,
                       .theta = 45 * degree + 4e-4 * std::sin(0.0628318530717958648 * i)});
    // to and fro within the stick range costs nothing: the moment came back to where it was
    EXPECT_NEAR(point.state.friction_moment, 0, 1e-6 * point.state.friction_limit);
    EXPECT_NEAR(point.state.friction_work, 0,
                1e-6 * 2 * point.state.friction_limit * 4e-4 / (0.909e-3 * 0.909e-3));
}

TEST(Friction, WhatIsStoredWhileStickingNeverGrowsByItself) {
    MaterialPoint<rubbing> point(elastic_kevlar129(), 1e-9);
    const auto go = [&point](double lambda, double from, double to) {
        for (int i = 0; i <= 100; ++i)
            point.advance({.lambda_f = lambda,
                           .lambda_w = lambda,
                           .theta = 45 * degree + from + (to - from) * i / 100});
    };
    const double angle = 5e-4;
    go(1.02, 0, angle);  // half-way to slip
    const double tight = point.state.friction_limit;
    go(1.01, angle, angle);
    const double loose = point.state.friction_limit;
    go(1.01, angle, 0);
    EXPECT_NEAR(loose / tight, 0.5, 0.02);
    // M angle^2/(2e-3) went in under the tight grip and came back under the loose one; M moves by less than
    // 1e-3 over this turn
    const double s = point.constants.fill.span,
                 expected = 2 / (s * s) * (tight - loose) * angle * angle / (2 * fabric::stick_angle);
    EXPECT_NEAR(point.state.friction_work / expected, 1, 4e-3);
}

TEST(Friction, OnlyYarnsThatPressRub) {
    MaterialPoint<rubbing> point(elastic_kevlar129(), 1e-9);
    for (int i = 1; i <= 20; ++i)
        point.advance({.lambda_f = 0.98, .lambda_w = 0.98, .theta = (45 + i) * degree});
    EXPECT_EQ(point.state.friction_work, 0);
}

TEST(Friction, TheSmallerPositiveForceCounts) {
    EXPECT_EQ(fabric::smaller_positive(2.0, 3.0), 2);
    EXPECT_EQ(fabric::smaller_positive(3.0, 2.0), 2);
    EXPECT_EQ(fabric::smaller_positive(-1.0, 2.0), 2);
    EXPECT_EQ(fabric::smaller_positive(2.0, -1.0), 2);
    EXPECT_EQ(fabric::smaller_positive(-2.0, -1.0), 0);
}

}  // namespace
}  // namespace weavefront::test
