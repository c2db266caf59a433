/// Forces as minus the gradient of what the elements store.

#include <gtest/gtest.h>

#include "elements.hpp"

namespace weavefront::test {
namespace {

/// |energy taken + mean force . displacement| for a step of `size` element sizes in a random direction from a
/// deformed state, over the scale of the energies at that size.
double defect(const scene::Fabric& fabric, int seed, double size) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    Elements elements(fabric, one_element(0.2, random), 0.3);
    const Wander wander(elements.mesh(), random, 0.05, 0.3, 0.15);
    Positions before;
    for (int i = 1; i <= 50; ++i) before = elements.nodal_forces(wander.at(i / 50.0));
    const double stored = elements.energy();
    Positions x = wander.at(1), du;
    for (auto& position : x) {
        du.push_back(random_vector(random, size * element_size));
        position += du.back();
    }
    const auto after = elements.nodal_forces(x);
    double work = 0;
    for (std::size_t n = 0; n < du.size(); ++n) work -= 0.5 * (before[n] + after[n]).dot(du[n]);
    return std::abs(elements.energy() - stored - work) /
           (membrane_stiffness(fabric) * element_size * element_size);
}

/// The trapezoidal work of a step is off by its third power.
void expect_third_order(const scene::Fabric& fabric) {
    double coarse = 0, fine = 0;
    for (int seed = 0; seed < 20; ++seed) {
        coarse += defect(fabric, seed, 4e-3);
        fine += defect(fabric, seed, 2e-3);
    }
    EXPECT_LT(coarse, 20 * 10 * std::pow(4e-3, 3));
    EXPECT_GT(std::log2(coarse / fine), 2.8);
}

TEST(Gradient, ForcesOfCrimpedYarns) { expect_third_order(open_trellis()); }

TEST(Gradient, ForcesOfStraightYarns) {
    scene::Fabric fabric = open_trellis();
    fabric.thickness = 0;
    expect_third_order(fabric);
}

TEST(Gradient, ForcesOfStiffHourglassModes) {
    scene::Fabric fabric = open_trellis();
    fabric.hourglass = 1;
    fabric.transverse_shear *= 20;
    expect_third_order(fabric);
}

TEST(Gradient, NothingIsMadeOrLostOverAClosedPath) {
    double left[2];
    for (const int refined : {0, 1}) {
        std::mt19937_64 random(7);
        scene::Fabric fabric = open_trellis();
        fabric.transverse_shear *= 20;
        Elements elements(fabric, grid(3, 0.2, random), 0.3);
        const Wander there(elements.mesh(), random, 0.05, 0.3, 0.15),
            aside(elements.mesh(), random, 0, 0, 0.15);
        Positions force_before(16, Eigen::Vector3d::Zero()), x_before = elements.mesh().X;
        double work = 0, peak = 0;
        const int steps = refined ? 800 : 400;
        for (int i = 1; i <= steps; ++i) {
            const double time = static_cast<double>(i) / steps, up = std::sin(std::numbers::pi * time);
            Positions x = there.at(up * up), other = aside.at(time * (1 - time) * 4);
            for (std::size_t n = 0; n < x.size(); ++n)
                x[n] += std::sin(2 * std::numbers::pi * time) * (other[n] - elements.mesh().X[n]);
            const auto force = elements.nodal_forces(x);
            for (std::size_t n = 0; n < x.size(); ++n)
                work -= 0.5 * (force_before[n] + force[n]).dot(x[n] - x_before[n]);
            peak = std::max(peak, work);
            force_before = force;
            x_before = x;
        }
        left[refined] = std::abs(work) / peak;
    }
    EXPECT_LT(left[1], 1e-4);
    EXPECT_LT(left[1], left[0] / 3.5 + 1e-12);  // order two
}

}  // namespace
}  // namespace weavefront::test
