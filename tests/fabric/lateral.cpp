/// The lateral contact factor and packing.

#include "weavefront/fabric/lateral.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "material_point.hpp"

namespace weavefront::test {
namespace {

constexpr fabric::Features packing{.formulation = consistent, .crimp = true, .lateral = true};
constexpr fabric::Features packing_paper{.formulation = paper, .crimp = true, .lateral = true};

TEST(Lateral, ContactFactorOfFigure8) {
    const fabric::Constants c = fabric::constants_of(kevlar129());
    for (const double side : {-1.0, 1.0}) {
        EXPECT_EQ(fabric::contact_factor(c, side * 31.9 * degree), 0);
        EXPECT_NEAR(fabric::contact_factor(c, side * 33.5 * degree), 0.5, 1e-13);
        EXPECT_NEAR(fabric::contact_factor(c, side * 35 * degree), 1, 1e-13);
        EXPECT_EQ(fabric::contact_factor(c, side * 44 * degree), 1);
    }
}

TEST(Lateral, TheBraidAngleIsFoundFromItsCosine) {
    for (double theta = 0.5; theta < 90; theta += 0.5) {
        const fabric::Trellis<double> trellis = fabric::trellis_of(std::cos(2 * theta * degree));
        // near 0 and 90 deg the cosine itself has lost the angle: d theta = d cos/(2 sin 2 theta)
        const double tolerance = 4e-16 * (1 + 1 / std::sin(2 * theta * degree));
        EXPECT_NEAR(fabric::angle_from_45(trellis), (theta - 45) * degree, tolerance);
        EXPECT_NEAR(trellis.sin_theta, std::sin(theta * degree), tolerance);
        EXPECT_NEAR(trellis.cos_theta, std::cos(theta * degree), tolerance);
        EXPECT_NEAR(trellis.sin_2theta, std::sin(2 * theta * degree), tolerance);
    }
}

TEST(Lateral, StrainIncrementsOfAPureTrellis) {
    // inextensible yarns: deps_x = -tan(theta) dtheta, deps_y = cot(theta) dtheta, up to the square of dtheta
    for (const double theta : {20.0, 45.0, 70.0}) {
        for (const double dtheta : {1e-3, 1e-4}) {
            const auto at = [](double angle) { return fabric::trellis_of(std::cos(2 * angle)); };
            const double middle = theta * degree;
            const fabric::PlaneTensor<double> dE = fabric::strain_increment(
                1.0, 1.0, at(middle - dtheta / 2), 1.0, 1.0, at(middle + dtheta / 2));
            EXPECT_NEAR(dE.xx, -std::tan(middle) * dtheta, 10 * dtheta * dtheta * dtheta + 1e-14);
            EXPECT_NEAR(dE.yy, dtheta / std::tan(middle), 10 * dtheta * dtheta * dtheta + 1e-14);
            EXPECT_NEAR(dE.xy, 0, 1e-14);
        }
    }
}

TEST(Lateral, StrainsAndStressesTurnIntoTheYarnsAxes) {
    const fabric::PlaneTensor<double> E{0.3, -0.2, 0.7};
    const double c = std::cos(30 * degree), s = std::sin(30 * degree);
    for (const double side : {s, -s}) {
        const std::array<double, 2> along{c, side}, across{-side, c};
        const auto component = [&E](const std::array<double, 2>& a, const std::array<double, 2>& b) {
            return a[0] * b[0] * E.xx + a[1] * b[1] * E.yy + (a[0] * b[1] + a[1] * b[0]) * E.xy;
        };
        const fabric::LateralStrain<double> strain = fabric::lateral_strain(E, c, side);
        EXPECT_NEAR(strain.eps_22, component(across, across), 1e-15);
        EXPECT_NEAR(strain.gamma_12, 2 * component(along, across), 1e-15);
        // and back
        const fabric::PlaneTensor<double> again = fabric::to_bisector_frame(
            component(along, along), component(across, across), component(along, across), c, side);
        EXPECT_NEAR(again.xx, E.xx, 1e-15);
        EXPECT_NEAR(again.yy, E.yy, 1e-15);
        EXPECT_NEAR(again.xy, E.xy, 1e-15);
    }
}

TEST(Lateral, PackedYarnsAnswerSpacingAndAngle) {
    // packed already at 45 deg, so that the forces are those of the total strain
    scene::Fabric fabric = elastic_kevlar129();
    fabric.lateral->locking_angle = 0;
    MaterialPoint<packing> point(fabric, 1e-9);
    const fabric::Constants& c = point.constants;
    ASSERT_EQ(point.state.alpha, 1);
    for (int i = 1; i <= 10; ++i)
        point.advance({.lambda_f = 1 + 1e-3 * i, .lambda_w = 1 - 2e-3 * i, .theta = (45 + i) * degree});
    const double sine = std::sin(110 * degree), tension = c.lateral_modulus * c.effective_thickness / 2;
    EXPECT_NEAR(point.state.p_f, tension * std::log(0.98 * sine), 1e-12 * tension);
    EXPECT_NEAR(point.state.p_w, tension * std::log(1.01 * sine), 1e-12 * tension);
    EXPECT_NEAR(point.state.q, c.shear_modulus * c.effective_thickness * 20 * degree, 1e-12 * tension);
    const double m = 2 / std::tan(110 * degree) * (point.state.p_f + point.state.p_w) + 2 * point.state.q;
    EXPECT_NEAR(point.state.m, m, 1e-12 * tension);
}

TEST(Lateral, AnOpenTrellisKeepsNoPackingForce) {
    MaterialPoint<packing> point(elastic_kevlar129(), 1e-9);
    for (int i = 1; i <= 40; ++i) point.advance({.theta = (45 + i) * degree});
    EXPECT_GT(std::abs(point.state.m), 0);
    for (int i = 39; i >= 0; --i) point.advance({.theta = (45 + i) * degree});
    EXPECT_EQ(point.state.p_f, 0);
    EXPECT_EQ(point.state.p_w, 0);
    EXPECT_EQ(point.state.q, 0);
    EXPECT_EQ(point.state.m, 0);
}

TEST(Lateral, AsPrintedAnOpenTrellisKeepsItsLateralStress) {
    MaterialPoint<packing_paper> point(elastic_kevlar129(), 1e-9);
    for (int i = 1; i <= 40; ++i) point.advance({.theta = (45 + i) * degree});
    for (int i = 39; i >= 0; --i) point.advance({.theta = (45 + i) * degree});
    // the way back out of the transition undoes what it did on the way in but for the step's second order
    for (int i = 1; i <= 40; ++i) point.advance({.lambda_f = 1 + 2e-3 * i, .theta = (45 + i) * degree});
    for (int i = 39; i >= 0; --i) point.advance({.lambda_f = 1.08, .theta = (45 + i) * degree});
    EXPECT_EQ(point.state.alpha, 0);
    EXPECT_GT(std::abs(point.state.sigma_22_w), 1e6);
}

TEST(Lateral, SymmetricAbout45Degrees) {
    // swapping the sense of the turn swaps the sign of the moment and nothing else
    MaterialPoint<packing> one(elastic_kevlar129(), 1e-9), other(elastic_kevlar129(), 1e-9);
    for (int i = 1; i <= 41; ++i) {
        const auto a = one.advance({.lambda_f = 1 + 1e-3 * i, .theta = (45 + i) * degree});
        const auto b = other.advance({.lambda_f = 1 + 1e-3 * i, .theta = (45 - i) * degree});
        const double scale = 1e-9 * one.constants.lateral_modulus * one.constants.effective_thickness;
        EXPECT_NEAR(a.T_xx, b.T_yy, scale);
        EXPECT_NEAR(a.T_yy, b.T_xx, scale);
        EXPECT_NEAR(a.T_xy, b.T_xy, scale);
        EXPECT_NEAR(one.state.m, -other.state.m, scale);
    }
}

}  // namespace
}  // namespace weavefront::test
