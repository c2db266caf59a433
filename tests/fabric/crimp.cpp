/// Crimp interchange against its closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "material_point.hpp"

namespace weavefront::test {
namespace {

constexpr fabric::Features elastic{.formulation = consistent, .crimp = true};
constexpr fabric::Features elastic_paper{.formulation = paper, .crimp = true};

template <fabric::Features F>
void expect_equibiaxial() {
    MaterialPoint<F> point(elastic_kevlar129(), 1e-9);
    const fabric::Constants& c = point.constants;
    for (const double lambda : {1.01, 1.05, 0.98, 1.2}) {
        point.advance({.lambda_f = lambda, .lambda_w = lambda});
        EXPECT_EQ(point.state.h_f, c.thickness / 4);  // nothing tells fill from warp: delta = 0 exactly
        const double length = std::hypot(lambda * c.fill.span / 2, c.thickness / 4);
        const fabric::YarnState<double> yarns = fabric::yarn_state<F>(c, point.state);
        EXPECT_NEAR(yarns.sigma_f, c.fill.static_modulus * (length / c.fill.length - 1),
                    1e-15 * 4 * c.fill.static_modulus);
        EXPECT_EQ(yarns.sigma_f, yarns.sigma_w);
    }
}

TEST(Crimp, EquibiaxialStretchMovesNoCrossover) { expect_equibiaxial<elastic>(); }
TEST(Crimp, EquibiaxialStretchMovesNoCrossoverAsPrinted) { expect_equibiaxial<elastic_paper>(); }

TEST(Crimp, UniaxialStretchStraightensTheFillUntilItsSlackIsGone) {
    // the warp is free: its span follows so that it carries nothing, h_w and lambda_w on the circle of its
    // length
    MaterialPoint<elastic> point(elastic_kevlar129(), 1e-9);
    const fabric::Constants& c = point.constants;
    const double slack = 2 * c.fill.length / c.fill.span;
    const int steps = 400;
    for (int i = 1; i <= steps; ++i) {
        const double lambda_f = 1 + (slack - 1) * i / steps;
        const double h_f = std::sqrt(std::max(
            0.0, c.fill.length * c.fill.length - lambda_f * lambda_f * c.fill.span * c.fill.span / 4));
        const double h_w = c.thickness / 2 - h_f;
        const double lambda_w = 2 * std::sqrt(c.fill.length * c.fill.length - h_w * h_w) / c.fill.span;
        point.advance({.lambda_f = lambda_f, .lambda_w = lambda_w});
        if (i == steps / 2) {
            EXPECT_NEAR(point.state.h_f, h_f, 1e-9 * c.thickness);
        }
    }
    // straight is where height is the square root of slack: rounding of the stretches, 1e-16, leaves 1e-8 of
    // the height
    EXPECT_NEAR(point.state.h_f, 0, 1e-7 * c.thickness);
    const double stiffness = c.fill.static_modulus * c.fill.area / c.fill.span;
    EXPECT_NEAR(point.state.N_f, 0, 1e-9 * stiffness);
    const double warp =
        2 * std::sqrt(c.fill.length * c.fill.length - c.thickness * c.thickness / 4) / c.fill.span;
    point.advance({.lambda_f = slack * 1.01, .lambda_w = warp});
    // beyond it the straight fill stretches; pressed flat it can lift the warp no further
    EXPECT_NEAR(point.state.N_f, stiffness * 0.01, 1e-3 * stiffness * 0.01);
}

TEST(Crimp, ForcesBalanceAtTheEndOfTheStep) {
    constexpr fabric::Features viscous{.formulation = consistent, .crimp = true, .viscous = true};
    MaterialPoint<viscous> point(kevlar129(), 1e-7);
    const fabric::Constants& c = point.constants;
    for (int i = 1; i <= 300; ++i) {
        point.advance({.lambda_f = 1 + 4e-4 * i, .lambda_w = 1 + 1e-4 * i});
        const fabric::State<double>& s = point.state;
        const fabric::BarLengths<double> L = fabric::bar_lengths<viscous>(c, s);
        const double lift_f = s.sigma_f * s.h_f / L.fill,
                     lift_w = s.sigma_w * (c.thickness / 2 - s.h_f) / L.warp;
        // the last Newton step is below 1e-8 t/2, so the heights are within about 1e-16 t/2; what is left is
        // rounding of the strains
        EXPECT_NEAR(lift_f, lift_w, 1e-14 * c.fill.hooke_modulus) << i;
    }
}

TEST(Crimp, MidStepBalanceConvergesToTheEndOfStepOne) {
    // the two formulations differ by the instant at which (29) holds; on a smooth path the difference
    // vanishes with the step
    const auto height = []<fabric::Features F>(int steps) {
        MaterialPoint<F> point(elastic_kevlar129(), 1e-9);
        for (int i = 1; i <= steps; ++i) {
            const double x = static_cast<double>(i) / steps;
            point.advance({.lambda_f = 1 + 0.05 * x * x, .lambda_w = 1 + 0.02 * x});
        }
        return point.state.h_f;
    };
    const double t = elastic_kevlar129().thickness;
    const double coarse =
        std::abs(height.operator()<elastic_paper>(100) - height.operator()<elastic>(100)) / t;
    const double fine = std::abs(height.operator()<elastic_paper>(400) - height.operator()<elastic>(400)) / t;
    EXPECT_LT(coarse, 1e-2);
    EXPECT_LT(fine, coarse / 3);
}

TEST(Crimp, TheCrossoverStaysWithinTheFabric) {
    constexpr fabric::Features F{.formulation = paper, .crimp = true, .viscous = true};
    MaterialPoint<F> point(kevlar129(), 1e-8);
    for (int i = 1; i <= 2000; ++i) {
        point.advance({.lambda_f = 1 + 0.3 * std::sin(0.05 * i), .lambda_w = 1 + 0.3 * std::sin(0.031 * i)});
        ASSERT_GE(point.state.h_f, 0.0);
        ASSERT_LE(point.state.h_f, point.constants.thickness / 2);
    }
}

}  // namespace
}  // namespace weavefront::test
