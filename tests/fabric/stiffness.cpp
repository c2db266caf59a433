/// The stiffness bound against difference quotients of the cell's nodal forces.

#include "weavefront/fabric/stiffness.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "material_point.hpp"
#include "weavefront/fabric/tangent.hpp"

namespace weavefront::test {
namespace {

using Vectors = std::array<double, 6>;  // g_f and g_w, three components each

constexpr fabric::Features F{
    .formulation = consistent, .crimp = true, .viscous = true, .lateral = true, .friction = true};

struct Local {
    double lambda_f, lambda_w, cos_2theta;
};

Local local(const Vectors& g) {
    const double f = std::hypot(g[0], g[1], g[2]), w = std::hypot(g[3], g[4], g[5]);
    return {f, w, (g[0] * g[3] + g[1] * g[4] + g[2] * g[5]) / (f * w)};
}

/// Forces per reference area conjugate to g: n_f d ln lambda_f/dg + n_w d ln lambda_w/dg + m dtheta/dg.
template <fabric::Features F>
Vectors forces(const MaterialPoint<F>& start, const Vectors& g) {
    MaterialPoint<F> point = start;
    const Local k = local(g);
    fabric::advance<F>(point.constants, point.step, point.state, k.lambda_f, k.lambda_w, k.cos_2theta);
    const double m = point.state.m + 2 * point.state.friction_moment / fabric::cell_area<F>(point.constants);
    const double sine = std::sqrt(1 - k.cos_2theta * k.cos_2theta);
    Vectors result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double d_f = g[i] / k.lambda_f, d_w = g[i + 3] / k.lambda_w;
        // dtheta = -d cos(2 theta)/(2 sin 2 theta)
        result[i] = point.state.N_f * d_f - 0.5 * m / sine * (d_w - k.cos_2theta * d_f) / k.lambda_f;
        result[i + 3] = point.state.N_w * d_w - 0.5 * m / sine * (d_f - k.cos_2theta * d_w) / k.lambda_w;
    }
    return result;
}

/// change . T change of the components in the plane, for yarn vectors in the plane z = 0.
double in_plane(const fabric::Tangent<double>& t, const Vectors& g, const Vectors& change) {
    const Local k = local(g);
    const double sine = std::sqrt(1 - k.cos_2theta * k.cos_2theta);
    std::array<double, 4> along{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double d_f = g[i] / k.lambda_f, d_w = g[i + 3] / k.lambda_w;
        along[0] += d_f * change[i];
        along[1] += (d_w - k.cos_2theta * d_f) / sine * change[i];
        along[2] += d_w * change[i + 3];
        along[3] += (k.cos_2theta * d_w - d_f) / sine * change[i + 3];
    }
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) sum += t[i][j] * along[i] * along[j];
    return sum;
}

/// The largest quotients of the cell's own stiffness and of a bound.
struct Tightest {
    double bound = 0, tangent = 0;
};

template <fabric::Features F>
Tightest expect_bounds_in_every_direction(const scene::Fabric& fabric) {
    std::mt19937_64 random(19);
    std::uniform_real_distribution<double> one(-1, 1);
    Tightest tightest;
    for (int n = 0; n < 3000; ++n) {
        MaterialPoint<F> point(fabric, 1e-9);
        const double turn = 43 * degree * one(random), f = 1.03 + 0.02 * one(random),
                     w = 1.03 + 0.02 * one(random);
        for (int i = 1; i <= 60; ++i) {
            const double x = i / 60.0;
            point.advance(
                {.lambda_f = 1 + (f - 1) * x, .lambda_w = 1 + (w - 1) * x, .theta = 45 * degree + turn * x});
        }
        const double theta = 45 * degree + turn;
        const Vectors g{f * std::cos(theta), f * std::sin(theta),  0,
                        w * std::cos(theta), -w * std::sin(theta), 0};
        const Vectors rest = forces(point, g);
        Vectors change{};
        const double size = 1e-7;
        Vectors moved = g;
        for (std::size_t i = 0; i < 6; ++i) moved[i] += change[i] = size * one(random);
        const Vectors there = forces(point, moved);
        double quotient = 0, dg_f = 0, dg_w = 0;
        for (std::size_t i = 0; i < 6; ++i) {
            quotient += (there[i] - rest[i]) * change[i];
            (i < 3 ? dg_f : dg_w) += change[i] * change[i];
        }
        const double dpsi = std::acos(local(moved).cos_2theta) - std::acos(local(g).cos_2theta);
        const fabric::Stiffness<double> k = fabric::stiffness_bound<F>(point.constants, point.state);
        const double bound =
            (k.yarn_f + k.lateral) * dg_f + (k.yarn_w + k.lateral) * dg_w + k.angle * dpsi * dpsi;
        EXPECT_LE(quotient, bound * (1 + 1e-5))
            << n << " turn " << turn / degree;  // the quotient is off by size over stick angle
        tightest.bound = std::max(tightest.bound, quotient / bound);
        if constexpr (F.unequal) continue;
        const double across = k.normal[0] * change[2] * change[2] + 2 * k.normal[1] * change[2] * change[5] +
                              k.normal[2] * change[5] * change[5];
        const double tangent =
            in_plane(fabric::tangent_bound<F>(point.constants, point.state), g, change) + across;
        EXPECT_LE(quotient, tangent * (1 + 1e-5)) << n << " turn " << turn / degree;
        tightest.tangent = std::max(tightest.tangent, quotient / tangent);
    }
    return tightest;
}

TEST(Stiffness, BoundsEveryDirectionOfTheTangent) {
    const auto tightest = expect_bounds_in_every_direction<F>(kevlar129());
    EXPECT_GT(tightest.bound, 0.5);  // not a bound for its own sake
    EXPECT_GT(tightest.tangent, 0.9);
}

TEST(Stiffness, BoundsEveryDirectionWhereFillAndWarpDiffer) {
    auto fabric = unequal_kevlar129();
    fabric.failure.reset();
    EXPECT_GT(expect_bounds_in_every_direction<fabric::any_unequal_fabric>(fabric).bound, 0.5);
    // yarns so soft that packing alone resists stretch
    for (auto* elastic : {&fabric.elastic, &fabric.warp->elastic})
        *elastic = {.static_modulus = 1e7, .hooke_modulus = 2e7, .viscosity = 0};
    fabric.lateral->locking_angle = 1e-3;
    // (x + y)^2 <= 2 x^2 + 2 y^2 separates stretch and angle: up to twice too stiff
    EXPECT_GT(expect_bounds_in_every_direction<fabric::any_unequal_fabric>(fabric).bound, 0.4);
}

TEST(Stiffness, StickingYarnsResistTheAngle) {
    MaterialPoint<F> point(kevlar129(), 1e-9);
    point.advance({.lambda_f = 1.02, .lambda_w = 1.02});
    const double bound = fabric::stiffness_bound<F>(point.constants, point.state).angle;
    const double dtheta = 1e-5, s = point.constants.fill.span;
    point.advance({.lambda_f = 1.02, .lambda_w = 1.02, .theta = 45 * degree + dtheta});
    // m/2 is conjugate to psi = 2 theta; the slip moment is flat at 45 deg
    EXPECT_NEAR(point.state.friction_moment / (s * s) / (2 * dtheta) / bound, 1, 1e-4);
}

TEST(Stiffness, AtRestItIsTheInstantaneousModulus) {
    const MaterialPoint<F> point(kevlar129(), 1e-9);
    const fabric::Stiffness<double> k = fabric::stiffness_bound<F>(point.constants, point.state);
    // Ka S/s, softened by the slope of the bars: L is the longer, the more crimp.
    EXPECT_NEAR(k.yarn_f, 192e9 * 6.48e-8 / 0.909e-3 * 0.909 / std::hypot(0.909, 0.41), 1e-3);
    EXPECT_EQ(k.yarn_f, k.yarn_w);
    EXPECT_EQ(k.lateral, 0);
    EXPECT_EQ(k.angle, 0);
}

}  // namespace
}  // namespace weavefront::test
