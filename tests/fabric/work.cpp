/// The work that the cell adds up, against the stress power, and objectivity.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "material_point.hpp"

namespace weavefront::test {
namespace {

constexpr fabric::Features all{
    .formulation = consistent, .crimp = true, .viscous = true, .lateral = true, .friction = true};
constexpr fabric::Features all_paper{
    .formulation = paper, .crimp = true, .viscous = true, .lateral = true, .friction = true};

/// A smooth path from rest through stretch, shear beyond locking and interchange.
Kinematics path(double x) {
    return {.lambda_f = 1 + 0.05 * x + 0.02 * std::sin(5 * x),
            .lambda_w = 1 + 0.03 * x * x,
            .theta = (45 + 42 * std::sin(1.5 * x)) * degree};
}

/// |work - integral of T : dE| over the path.
template <fabric::Features F>
double defect(int steps, double* total) {
    MaterialPoint<F> point(kevlar129(), 1e-4 / steps);
    fabric::Response<double> last{};
    double power = 0;
    for (int i = 1; i <= steps; ++i) {
        const Kinematics from = path((i - 1.0) / steps), to = path(static_cast<double>(i) / steps);
        const fabric::Response<double> response = point.advance(to);
        const auto trellis = [](const Kinematics& k) { return fabric::trellis_of(std::cos(2 * k.theta)); };
        const fabric::PlaneTensor<double> dE = fabric::strain_increment(
            from.lambda_f, from.lambda_w, trellis(from), to.lambda_f, to.lambda_w, trellis(to));
        power += 0.5 * ((last.T_xx + response.T_xx) * dE.xx + (last.T_yy + response.T_yy) * dE.yy) +
                 (last.T_xy + response.T_xy) * dE.xy;
        last = response;
    }
    *total = power;
    return std::abs(point.state.work + point.state.friction_work - power);
}

template <fabric::Features F>
void expect_work_of_stress_power() {
    double total = 0;
    const double coarse = defect<F>(1000, &total), fine = defect<F>(2000, &total);
    EXPECT_LT(fine, 1e-4 * total);
    EXPECT_GT(std::log2(coarse / fine), 1.9);
}

TEST(Work, EqualsTheStressPower) { expect_work_of_stress_power<all>(); }
TEST(Work, EqualsTheStressPowerAsPrinted) { expect_work_of_stress_power<all_paper>(); }

TEST(Work, ForcesAndResultantsAreEachOthersInverse) {
    for (double theta = 5; theta < 90; theta += 7) {
        const fabric::Trellis<double> trellis = fabric::trellis_of(std::cos(2 * theta * degree));
        const fabric::Forces<double> n =
            fabric::forces(fabric::resultants(fabric::Forces<double>{3, -2, 0.7}, trellis), trellis);
        EXPECT_NEAR(n.fill, 3, 1e-13);
        EXPECT_NEAR(n.warp, -2, 1e-13);
        EXPECT_NEAR(n.angle, 0.7, 1e-12);
    }
}

TEST(Work, AnElasticYarnStoresItsEnergy) {
    constexpr fabric::Features elastic{.formulation = consistent};
    scene::Fabric fabric = elastic_kevlar129();
    fabric.thickness = 0;
    MaterialPoint<elastic> point(fabric, 1e-9);
    point.advance({.lambda_f = 1.03});
    // linear force: the trapezoid is exact
    EXPECT_NEAR(point.state.work, 0.5 * 96e9 * 0.03 * 0.03 * fabric.yarn.area / fabric.yarn.span, 1e-9);
}

/// Stretches and angle of a deformation gradient given by rows.
Kinematics of(const std::array<double, 4>& F) {
    const double f = std::hypot(F[0], F[2]), w = std::hypot(F[1], F[3]);
    return {f, w, 0.5 * std::acos((F[0] * F[1] + F[2] * F[3]) / (f * w))};
}

TEST(Work, ASpinningObserverSeesTheSameResponse) {
    MaterialPoint<all> still(kevlar129(), 1e-7), spun(kevlar129(), 1e-7);
    for (int i = 1; i <= 200; ++i) {
        const double x = i / 200.0, a = 40 * x, c = std::cos(a), s = std::sin(a);
        const std::array<double, 4> F{1 + 0.05 * x, 0.4 * x * x, -0.1 * x, 1 + 0.03 * x};
        const std::array<double, 4> RF{c * F[0] - s * F[2], c * F[1] - s * F[3], s * F[0] + c * F[2],
                                       s * F[1] + c * F[3]};
        const fabric::Response<double> one = still.advance(of(F)), other = spun.advance(of(RF));
        const double scale = 1e-11 * still.constants.fill.hooke_modulus * still.constants.fill.area /
                             still.constants.fill.span;
        ASSERT_NEAR(one.T_xx, other.T_xx, scale);
        ASSERT_NEAR(one.T_yy, other.T_yy, scale);
        ASSERT_NEAR(one.T_xy, other.T_xy, scale);
    }
}

}  // namespace
}  // namespace weavefront::test
