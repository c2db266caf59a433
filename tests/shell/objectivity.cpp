/// What a turning observer sees.

#include <gtest/gtest.h>

#include "elements.hpp"

namespace weavefront::test {
namespace {

Eigen::Matrix3d turn(double time) {
    return (Eigen::AngleAxisd(3 * time, Eigen::Vector3d(1, 2, -1).normalized()) *
            Eigen::AngleAxisd(5 * time * time, Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

void expect_forces_to_turn(scene::Formulation formulation) {
    std::mt19937_64 random(5);
    scene::Fabric fabric = kevlar129();
    fabric.formulation = formulation;
    const auto mesh = grid(4, 0.25, random);
    Elements still(fabric, mesh, 0.3), turning(fabric, mesh, 0.3);
    const Wander wander(mesh, random, 0.08, 0.7, 0.1);
    double peak = 0, worst = 0;
    for (int i = 1; i <= 200; ++i) {
        const auto x = wander.at(i / 200.0);
        const Eigen::Matrix3d R = turn(i / 200.0);
        Positions Rx;
        for (const auto& position : x) Rx.push_back(R * position);
        const auto forces = still.nodal_forces(x), seen = turning.nodal_forces(Rx);
        peak = std::max(peak, largest(forces));
        for (std::size_t n = 0; n < forces.size(); ++n)
            worst = std::max(worst, (R * forces[n] - seen[n]).norm());
    }
    // Positions are rounded to 1e-16 of the patch of four elements: 4e-16 of strain a step, on the whole
    // membrane stiffness; 200 steps.
    EXPECT_LT(worst, 200 * 1e-15 * 2 * membrane_stiffness(fabric) * element_size);
    EXPECT_GT(peak, 1e-3 * membrane_stiffness(fabric) * element_size);
    EXPECT_NEAR(turning.energy() / still.energy(), 1, 1e-11);
}

void expect_rest_in_a_rigid_turn(scene::Formulation formulation) {
    std::mt19937_64 random(6);
    scene::Fabric fabric = kevlar129();
    fabric.formulation = formulation;
    Elements elements(fabric, grid(4, 0.25, random), 0.3);
    for (int i = 1; i <= 100; ++i) {
        Positions x;
        for (const auto& X : elements.mesh().X)
            x.push_back(turn(i / 100.0) * X + Eigen::Vector3d(0, 0, 1e-3 * i));
        // the patch is now at up to 0.1 m from the origin: its positions are rounded to 1e-17 m, 1e-14 of an
        // element
        EXPECT_LT(largest(elements.nodal_forces(x)), 1e-13 * membrane_stiffness(fabric) * element_size);
    }
    EXPECT_LT(std::abs(elements.energy()), 1e-24 * membrane_stiffness(fabric));
}

TEST(Objectivity, TheForcesTurnWithTheObserver) { expect_forces_to_turn(scene::Formulation::consistent); }
TEST(Objectivity, TheForcesTurnWithTheObserverAsPrinted) { expect_forces_to_turn(scene::Formulation::paper); }
TEST(Objectivity, ARigidTurnMakesNoForce) { expect_rest_in_a_rigid_turn(scene::Formulation::consistent); }
TEST(Objectivity, ARigidTurnMakesNoForceAsPrinted) { expect_rest_in_a_rigid_turn(scene::Formulation::paper); }

}  // namespace
}  // namespace weavefront::test
