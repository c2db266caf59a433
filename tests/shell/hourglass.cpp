/// Warping and in-plane hourglass modes.

#include "weavefront/shell/hourglass.hpp"

#include <gtest/gtest.h>

#include "elements.hpp"

namespace weavefront::test {
namespace {

constexpr double a = 2e-3, b = 0.7e-3;

Corners rectangle() {
    return {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(a, 0, 0), Eigen::Vector3d(a, b, 0),
            Eigen::Vector3d(0, b, 0)};
}

double shape() { return (b / a + a / b) * 4 / 3; }

/// Moves the corners by +u, -u, +u, -u and expects the energy k u^2/2 and the forces that belong to it, at
/// any size of u: the point at the centre sees no strain.
/// @param excess of the warping stiffness over the other, N/m: its energy grows with the area, which pulls
/// the corners together
void expect_spring(const scene::Fabric& fabric, const Eigen::Vector3d& u, double k, double excess) {
    Elements elements(fabric, one_element(rectangle()), 0.2);
    Positions x = elements.mesh().X;
    for (std::size_t n = 0; n < 4; ++n) x[n] += (n % 2 == 0 ? 1 : -1) * u;
    const auto forces = elements.nodal_forces(x);
    const auto energy = elements.group->energy(0);
    EXPECT_NEAR(energy.hourglass / (k * u.squaredNorm() / 2), 1, 1e-12);
    EXPECT_NEAR(energy.work, 0, 1e-20 * membrane_stiffness(fabric));
    for (std::size_t n = 0; n < 4; ++n) {
        const Eigen::Vector3d outwards((n == 1 || n == 2 ? 0.5 : -0.5) / a, (n >= 2 ? 0.5 : -0.5) / b,
                                       0);  // gradient of the area/area
        const Eigen::Vector3d expected =
            (n % 2 == 0 ? -0.25 : 0.25) * k * u - excess * u.z() * u.z() / 2 * outwards;
        EXPECT_LT((forces[n] - expected).norm(), 1e-12 * k * u.norm()) << n;
    }
}

TEST(Hourglass, WarpingIsTransverseShearInClosedForm) {
    const scene::Fabric fabric = open_trellis();
    const double k = fabric.transverse_shear * fabric.effective_thickness() * shape(),
                 in_plane = fabric.hourglass * membrane_stiffness(fabric) / 2 * shape();
    for (const double w : {1e-6, 1e-4}) expect_spring(fabric, {0, 0, w}, k, k - in_plane);
}

TEST(Hourglass, InThePlaneIsAPartOfTheMembrane) {
    scene::Fabric fabric = open_trellis();
    for (const double part : {0.05, 1.0}) {
        fabric.hourglass = part;
        expect_spring(fabric, {1e-5, -2e-5, 0}, part * membrane_stiffness(fabric) / 2 * shape(), 0);
    }
}

TEST(Hourglass, IsGoneWithoutItsStiffness) {
    scene::Fabric fabric = open_trellis();
    fabric.hourglass = fabric.transverse_shear = 0;
    Elements elements(fabric, one_element(rectangle()), 0.2);
    Positions x = elements.mesh().X;
    for (std::size_t n = 0; n < 4; ++n) x[n] += (n % 2 == 0 ? 1 : -1) * Eigen::Vector3d(1e-5, 1e-5, 1e-5);
    EXPECT_LT(largest(elements.nodal_forces(x)), 1e-14 * membrane_stiffness(fabric) * a);
}

/// q, g_f and g_w in one.
using Arguments = std::array<double, 9>;

shell::HourglassForce<double> evaluate(const Arguments& z) {
    const auto v = [&](std::size_t i) { return shell::Vector<double>{z[i], z[i + 1], z[i + 2]}; };
    const shell::HourglassStiffness stiffness{.in_plane = 3, .warping = 40};
    const shell::Quad<double> quad{0, 0, 0, 0, 0, 0, 1, 2.5};
    const shell::Kinematics<double> k{v(3), v(6), v(0)};
    const auto normal = cross(k.g_f, k.g_w);
    return shell::hourglass_force(stiffness, quad, k, normal, std::sqrt(dot(normal, normal)));
}

TEST(Hourglass, TheForcesAreTheDerivativesOfTheEnergy) {
    std::mt19937_64 random(8);
    for (int n = 0; n < 100; ++n) {
        const auto q = random_vector(random, 0.5), f = random_vector(random, 0.3),
                   w = random_vector(random, 0.3);
        const Arguments z{q.x(), q.y(), q.z(), 1 + f.x(), f.y(), f.z(), w.x(), 1 + w.y(), w.z()};
        const auto at = evaluate(z);
        const Arguments closed{at.force.x, at.force.y, at.force.z, at.P_f.x, at.P_f.y,
                               at.P_f.z,   at.P_w.x,   at.P_w.y,   at.P_w.z};
        const auto error = [&](double h) {
            double squared = 0;
            for (std::size_t i = 0; i < z.size(); ++i) {
                auto ahead = z, behind = z;
                ahead[i] += h;
                behind[i] -= h;
                squared +=
                    std::pow((evaluate(ahead).energy - evaluate(behind).energy) / (2 * h) - closed[i], 2);
            }
            return std::sqrt(squared);
        };
        // the energy is of the size of 40, its third derivatives not above some hundreds
        ASSERT_LT(error(1e-4), 1e-4);
        ASSERT_GT(std::log2(error(2e-2) / error(1e-2)), 1.8);
    }
}

TEST(Hourglass, LeavesWithAnErodedElement) {
    auto fabric = open_trellis();
    fabric.failure = scene::Failure{.static_strain = 1, .hooke_strain = 1};
    Elements elements(fabric, one_element(rectangle()), 0);
    Positions x = elements.mesh().X;
    x[0].z() = 1e-4;
    x[1].x() += 1e-5;
    elements.nodal_forces(x);
    const auto held = elements.group->energy(0);
    ASSERT_GT(held.hourglass, 0);
    const auto left = elements.group->erode(0);
    EXPECT_EQ(left.hourglass, held.hourglass);
    EXPECT_EQ(left.work, held.work);
    EXPECT_FALSE(elements.group->alive(0));
    EXPECT_EQ(largest(elements.nodal_forces(x)), 0);
    EXPECT_EQ(elements.energy(), 0);
    EXPECT_EQ(elements.group->frequencies().in_plane, 0);
    EXPECT_EQ(elements.group->frequencies().out_of_plane, 0);
}

}  // namespace
}  // namespace weavefront::test
