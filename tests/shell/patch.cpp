/// The patch test, and the resultants of the internal forces.

#include <gtest/gtest.h>

#include "elements.hpp"

namespace weavefront::test {
namespace {

TEST(Patch, AUniformDeformationIsExactOnADistortedMesh) {
    std::mt19937_64 random(1);
    scene::Fabric fabric = open_trellis();
    fabric.thickness = 0;
    const double angle = 0.4;
    Elements elements(fabric, grid(5, 0.3, random), angle);
    Eigen::Matrix<double, 3, 2> F;
    F << 1.02, 0.3, -0.1, 1.01, 0.2, -0.4;
    Positions x;
    for (const auto& X : elements.mesh().X) x.push_back(F * X.head<2>());
    const auto forces = elements.nodal_forces(x);
    const Eigen::Vector3d g_f = F * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                          g_w = F * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
    for (std::int32_t e = 0; e < elements.group->size(); ++e) {
        const auto output = elements.group->output(e, x);
        EXPECT_NEAR(output.strain_fill, g_f.norm() - 1, 1e-14);
        EXPECT_NEAR(output.strain_warp, g_w.norm() - 1, 1e-14);
        EXPECT_NEAR(output.braid_angle, std::acos(g_f.normalized().dot(g_w.normalized())) / 2, 1e-14);
        EXPECT_LT(elements.group->energy(e).hourglass, 1e-24 * elements.group->energy(e).work);
    }
    for (int j = 1; j < 5; ++j)
        for (int i = 1; i < 5; ++i)
            EXPECT_LT(forces[static_cast<std::size_t>(j * 6 + i)].norm(), 1e-13 * largest(forces))
                << i << ' ' << j;
}

TEST(Patch, TheBoundaryForcesCarryTheStress) {
    // a square pulled along its straight fill: E1 S/s eps per length, times the stretch of the other sides,
    // none
    scene::Fabric fabric = open_trellis();
    fabric.thickness = 0;
    std::mt19937_64 random(1);
    Elements elements(fabric, grid(4, 0.3, random), 0);
    Positions x = elements.mesh().X;
    for (auto& position : x) position.x() *= 1.02;
    const auto forces = elements.nodal_forces(x);
    double pull = 0;
    for (std::size_t n = 4; n < 25; n += 5) pull += forces[n].x();
    EXPECT_NEAR(pull / (-membrane_stiffness(fabric) * 0.02 * 4 * element_size), 1, 1e-13);
}

void expect_no_resultants(scene::Formulation formulation) {
    std::mt19937_64 random(3);
    scene::Fabric fabric = kevlar129();
    fabric.formulation = formulation;
    Elements elements(fabric, grid(4, 0.25, random), 0.3);
    const Wander wander(elements.mesh(), random, 0.08, 0.7, 0.1);
    for (int i = 1; i <= 50; ++i) {
        const auto x = wander.at(i / 50.0);
        const auto forces = elements.corner_forces(x);
        for (std::size_t e = 0; e < forces.size(); ++e) {
            Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
            double size = 0;
            const auto corners = corners_of(elements.mesh(), e, x);
            for (std::size_t a = 0; a < 4; ++a) {
                force += forces[e][a];
                moment += (corners[a] - corners[0]).cross(forces[e][a]);
                size = std::max(size, forces[e][a].norm());
            }
            ASSERT_LT(force.norm(), 1e-15 * size);
            ASSERT_LT(moment.norm(), 1e-13 * size * element_size) << e << " at " << i;
        }
    }
}

TEST(Patch, ForceAndMomentResultantsVanish) { expect_no_resultants(scene::Formulation::consistent); }
TEST(Patch, ForceAndMomentResultantsVanishAsPrinted) { expect_no_resultants(scene::Formulation::paper); }

TEST(Patch, IdleLanesOfAPackDoNothing) {
    // nine elements fill one pack and one lane of another: the ninth alone must see the same as in a group of
    // its own
    std::mt19937_64 random(4);
    Elements nine(kevlar129(), grid(3, 0.2, random), 0.3);
    const auto& mesh = nine.mesh();
    Elements last(kevlar129(), Mesh{mesh.X, {mesh.elements[8]}}, 0.3);
    const Wander wander(mesh, random, 0.05, 0.5, 0.1);
    for (int i = 1; i <= 20; ++i) {
        const auto x = wander.at(i / 20.0);
        ASSERT_EQ(nine.corner_forces(x)[8], last.corner_forces(x)[0]);
    }
    EXPECT_EQ(nine.group->size(), 9);
    EXPECT_EQ(nine.group->packs(), 2);
}

}  // namespace
}  // namespace weavefront::test
