/// Yarn viscoelasticity against its closed forms, through the kernel of straight yarns (t = 0): the yarn
/// strain is lambda - 1.

#include <gtest/gtest.h>

#include <cmath>

#include "material_point.hpp"

namespace weavefront::test {
namespace {

constexpr fabric::Features exact{.formulation = consistent, .viscous = true};
constexpr fabric::Features trapezoidal{.formulation = paper, .viscous = true};

scene::Fabric straight() {
    scene::Fabric fabric = kevlar129();
    fabric.thickness = 0;
    return fabric;
}

double at_constant_rate(const fabric::Constants& c, double rate, double time) {
    const double tau = c.fill.relaxation_time;
    return c.fill.static_modulus * rate * time +
           (c.fill.hooke_modulus - c.fill.static_modulus) * rate * tau * -std::expm1(-time / tau);
}

/// Stress after `time` at a constant strain rate, in `steps` steps.
template <fabric::Features F>
double constant_rate(double rate, double time, int steps) {
    MaterialPoint<F> point(straight(), time / steps);
    for (int i = 1; i <= steps; ++i) point.advance({.lambda_f = 1 + rate * time * i / steps});
    return point.state.sigma_f;
}

TEST(Yarn, RelaxationTimeOfKevlar) {
    const fabric::Constants c = fabric::constants_of(straight());
    // Kb = Ka E1/(Ka - E1) = 192 GPa, so tau = 35 MPa s/384 GPa
    EXPECT_NEAR(c.fill.relaxation_time, 35e6 / 384e9, 1e-18);
}

TEST(Yarn, ConstantRateIsExactAtAnyStep) {
    const fabric::Constants c = fabric::constants_of(straight());
    for (const double rate : {0.001, 10.0, 500.0}) {
        const double time = 0.03 / rate;
        for (const int steps : {1, 7, 1000}) {
            const double expected = at_constant_rate(c, rate, time);
            // each step rounds the strain, 1e-16 of a stretch of about 1
            EXPECT_NEAR(constant_rate<exact>(rate, time, steps), expected,
                        steps * 2.3e-16 * c.fill.hooke_modulus)
                << rate << ' ' << steps;
        }
    }
}

TEST(Yarn, TrapezoidalRuleConvergesAtOrderTwo) {
    const fabric::Constants c = fabric::constants_of(straight());
    const double rate = 100, time = 3e-4, expected = at_constant_rate(c, rate, time);
    const double coarse = std::abs(constant_rate<trapezoidal>(rate, time, 40) - expected);
    const double fine = std::abs(constant_rate<trapezoidal>(rate, time, 80) - expected);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02);
}

TEST(Yarn, StepStrainRelaxesExponentially) {
    const fabric::Constants c = fabric::constants_of(straight());
    const double e0 = 0.01;
    MaterialPoint<exact> point(straight(), 0.0);
    point.advance({.lambda_f = 1 + e0});  // no time passes: the spring Ka takes it all
    EXPECT_NEAR(point.state.sigma_f, c.fill.hooke_modulus * e0, 1e-15 * c.fill.hooke_modulus);
    point.step = fabric::step_of(c, exact, 20e-6);
    for (int i = 1; i <= 30; ++i) {
        point.advance({.lambda_f = 1 + e0});
        const double expected =
            e0 * (c.fill.static_modulus + (c.fill.hooke_modulus - c.fill.static_modulus) *
                                              std::exp(-i * 20e-6 / c.fill.relaxation_time));
        EXPECT_NEAR(point.state.sigma_f, expected, 1e-14 * c.fill.hooke_modulus);
    }
}

struct Moduli {
    double storage, loss;
};

/// Moduli from the last of ten periods of a harmonic strain, the first of which swing in.
template <fabric::Features F>
Moduli harmonic(double omega, int steps_per_period) {
    const double amplitude = 1e-3, dt = 2 * std::numbers::pi / omega / steps_per_period;
    MaterialPoint<F> point(straight(), dt);
    Moduli sum{};
    for (int i = 1; i <= 10 * steps_per_period; ++i) {
        const double phase = 2 * std::numbers::pi * i / steps_per_period;
        point.advance({.lambda_f = 1 + amplitude * std::sin(phase)});
        if (i <= 9 * steps_per_period) continue;
        sum.storage += point.state.sigma_f * std::sin(phase) * 2 / (amplitude * steps_per_period);
        sum.loss += point.state.sigma_f * std::cos(phase) * 2 / (amplitude * steps_per_period);
    }
    return sum;
}

template <fabric::Features F>
void expect_moduli_of_order_two() {
    const fabric::Constants c = fabric::constants_of(straight());
    for (const double omega_tau : {0.5, 1.0, 3.0}) {
        const double omega = omega_tau / c.fill.relaxation_time, x = omega_tau * omega_tau;
        const double extra = c.fill.hooke_modulus - c.fill.static_modulus;
        const Moduli closed{c.fill.static_modulus + extra * x / (1 + x), extra * omega_tau / (1 + x)};
        const Moduli coarse = harmonic<F>(omega, 64), fine = harmonic<F>(omega, 128);
        EXPECT_NEAR(fine.storage / closed.storage, 1, 1e-3);
        EXPECT_NEAR(fine.loss / closed.loss, 1, 1e-3);
        const auto error = [&closed](const Moduli& m) {
            return std::hypot(m.storage - closed.storage, m.loss - closed.loss);
        };
        EXPECT_NEAR(std::log2(error(coarse) / error(fine)), 2.0, 0.05) << omega_tau;
    }
}

TEST(Yarn, HarmonicModuliExactUpdate) { expect_moduli_of_order_two<exact>(); }
TEST(Yarn, HarmonicModuliTrapezoidalRule) { expect_moduli_of_order_two<trapezoidal>(); }

TEST(Yarn, LongStepsEndAtTheStaticModulus) {
    const fabric::Constants c = fabric::constants_of(straight());
    for (const double a : {1e3, 1e6, 1e12}) {
        MaterialPoint<exact> point(straight(), a * c.fill.relaxation_time);
        point.advance({.lambda_f = 1.01});
        EXPECT_NEAR(point.state.sigma_f / (c.fill.static_modulus * 0.01), 1, 1.1 / a + 1e-13);
    }
}

TEST(Yarn, WithoutViscosityTheStressFollowsTheStrain) {
    constexpr fabric::Features elastic{.formulation = consistent};
    scene::Fabric fabric = straight();
    fabric.elastic.viscosity = 0;
    MaterialPoint<elastic> point(fabric, 1e-9);
    const double lambda = 1.02;
    const fabric::Response<double> response = point.advance({.lambda_f = lambda});
    const fabric::Constants& c = point.constants;
    const double n = c.fill.static_modulus * 0.02 * c.fill.area / c.fill.span * lambda;
    // the fill alone pulls, at 45 deg to the axes
    EXPECT_NEAR(response.T_xx, n / 2, 1e-13 * n);
    EXPECT_NEAR(response.T_yy, n / 2, 1e-13 * n);
    EXPECT_NEAR(response.T_xy, n / 2, 1e-13 * n);
}

}  // namespace
}  // namespace weavefront::test
