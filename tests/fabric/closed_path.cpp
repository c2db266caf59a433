/// Energy over closed paths: none made, none lost but by what dissipates.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "material_point.hpp"

namespace weavefront::test {
namespace {

/// A random closed path through stretches and angle that begins and ends at rest.
class ClosedPath {
  public:
    ClosedPath(std::mt19937_64& random, double stretch, double turn) {
        std::uniform_real_distribution<double> one(-1, 1);
        for (auto& amplitude : f_) amplitude = stretch * one(random);
        for (auto& amplitude : w_) amplitude = stretch * one(random);
        for (auto& amplitude : theta_) amplitude = one(random);
        const double sum = std::abs(theta_[0]) + std::abs(theta_[1]) + std::abs(theta_[2]);
        for (auto& amplitude : theta_) amplitude *= turn / sum;  // never turns further than `turn`
        pull_ = stretch;
    }
    [[nodiscard]] Kinematics at(double x) const {
        const double away = std::pow(std::sin(std::numbers::pi * x), 2);
        const auto wander = [x, away](const std::array<double, 3>& a) {
            const double turn = 2 * std::numbers::pi * x;
            return away * (a[0] + a[1] * std::sin(turn) + a[2] * std::cos(2 * turn));
        };
        return {.lambda_f = 1 + pull_ * away + wander(f_) / 3,
                .lambda_w = 1 + pull_ * away + wander(w_) / 3,
                .theta = 45 * degree + wander(theta_)};
    }

  private:
    std::array<double, 3> f_{}, w_{}, theta_{};
    double pull_ = 0;
};

struct Energy {
    double left = 0;  ///< work over the closed path, J/m2
    double peak = 0;  ///< largest work on the way
};

template <fabric::Features F>
Energy walk(const scene::Fabric& fabric, const ClosedPath& path, int steps) {
    MaterialPoint<F> point(fabric, 1e-9);
    Energy energy;
    for (int i = 1; i <= steps; ++i) {
        point.advance(path.at(static_cast<double>(i) / steps));
        energy.left = point.state.work + point.state.friction_work;
        energy.peak = std::max(energy.peak, energy.left);
    }
    return energy;
}

TEST(ClosedPath, AnOpenTrellisOfElasticYarnsReturnsEverything) {
    constexpr fabric::Features F{.formulation = consistent, .crimp = true};
    std::mt19937_64 random(11);
    for (int n = 0; n < 20; ++n) {
        const ClosedPath path(random, 0.05, 43 * degree);
        const Energy coarse = walk<F>(elastic_kevlar129(), path, 400), fine = walk<F>(elastic_kevlar129(), path, 1600);
        EXPECT_LT(std::abs(fine.left), 1e-5 * fine.peak) << n;
        // order two: a step of a quarter leaves a sixteenth, or better
        EXPECT_LT(std::abs(fine.left), std::abs(coarse.left) / 12 + 1e-12 * fine.peak) << n;
    }
}

/// Walks 10^4 random paths with the parts of F; what comes out may fall below zero only by the trapezoid's error, which the elastic open
/// trellis shows by itself on the same paths.
template <fabric::Features F>
void expect_only_losses(int least_dissipating) {
    constexpr fabric::Features elastic{.formulation = consistent, .crimp = true};
    std::mt19937_64 random(13);
    int dissipating = 0;
    double gain = 0, error = 0;
    for (int n = 0; n < 10000; ++n) {
        const ClosedPath path(random, 0.04, 43 * degree);
        const Energy energy = walk<F>(elastic_kevlar129(), path, 200), open = walk<elastic>(elastic_kevlar129(), path, 200);
        gain = std::max(gain, -energy.left / energy.peak);
        error = std::max(error, std::abs(open.left) / open.peak);
        if (energy.left > 1e-3 * energy.peak) ++dissipating;
    }
    EXPECT_LT(gain, 2 * error);
    EXPECT_LT(error, 1e-4);
    EXPECT_GT(dissipating, least_dissipating);  // the paths do lock and rub
}

TEST(ClosedPath, PackingOnlyTakesEnergy) {
    expect_only_losses<fabric::Features{.formulation = consistent, .crimp = true, .lateral = true}>(1000);
}
TEST(ClosedPath, FrictionOnlyTakesEnergy) {
    expect_only_losses<fabric::Features{.formulation = consistent, .crimp = true, .friction = true}>(9000);
}
TEST(ClosedPath, PackingAndFrictionOnlyTakeEnergy) {
    expect_only_losses<fabric::Features{.formulation = consistent, .crimp = true, .lateral = true, .friction = true}>(9000);
}

TEST(ClosedPath, ViscousYarnsOnlyTakeEnergy) {
    constexpr fabric::Features F{.formulation = consistent, .crimp = true, .viscous = true};
    std::mt19937_64 random(17);
    for (int n = 0; n < 1000; ++n) {
        const ClosedPath path(random, 0.04, 43 * degree);
        MaterialPoint<F> point(kevlar129(), 1e-6);
        for (int i = 1; i <= 200; ++i) point.advance(path.at(i / 200.0));
        ASSERT_GT(point.state.work, 0) << n;
    }
}

TEST(ClosedPath, AsPrintedEnergyIsMadeOrLost) {
    // stretch, shear, release, unshear: the printed stress uses the initial span and no crimp angle, so the way back differs
    constexpr fabric::Features F{.formulation = paper, .crimp = true};
    const auto left = [](bool shear_first) {
        MaterialPoint<F> point(elastic_kevlar129(), 1e-9);
        double peak = 0;
        const int steps = 500;
        for (int leg = 0; leg < 4; ++leg) {
            for (int i = 1; i <= steps; ++i) {
                const double x = static_cast<double>(i) / steps;
                const double first = leg == 0   ? x
                                     : leg == 2 ? 1 - x
                                     : leg < 2  ? 1
                                                : 0,
                             second = leg == 1   ? x
                                      : leg == 3 ? 1 - x
                                      : leg > 1  ? 1
                                                 : 0;
                const double stretch = shear_first ? second : first, shear = shear_first ? first : second;
                point.advance({.lambda_f = 1 + 0.04 * stretch, .lambda_w = 1 + 0.04 * stretch, .theta = (45 + 20 * shear) * degree});
                peak = std::max(peak, point.state.work);
            }
        }
        return point.state.work / peak;
    };
    EXPECT_GT(std::abs(left(false)), 0.05);
    EXPECT_LT(left(false) * left(true), 0);
}

}  // namespace
}  // namespace weavefront::test
