/// Energy over closed paths: none made, none lost but by what dissipates.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "closed_paths.hpp"

namespace weavefront::test {
namespace {

constexpr fabric::Features elastic{.formulation = consistent, .crimp = true};

TEST(ClosedPath, AnOpenTrellisOfElasticYarnsReturnsEverything) {
    std::mt19937_64 random(11);
    for (int n = 0; n < 20; ++n) {
        const SmoothPath path(random, 0.05, 43 * degree);
        const ClosedWork coarse = walk<elastic>(elastic_kevlar129(), path, 400),
                         fine = walk<elastic>(elastic_kevlar129(), path, 1600);
        EXPECT_LT(std::abs(fine.left), 1e-5 * fine.peak) << n;
        // order two: a step of a quarter leaves a sixteenth, or better
        EXPECT_LT(std::abs(fine.left), std::abs(coarse.left) / 12 + 1e-12 * fine.peak) << n;
    }
}

TEST(ClosedPath, WhatAnOpenTrellisLeavesIsOfOrderTwo) {
    // Corners, compression and interchange, so that nothing cancels by smoothness; the largest of 200 paths,
    // at each halving of the step.
    std::array<double, 5> largest{};
    for (std::size_t halving = 0; halving < largest.size(); ++halving) {
        std::mt19937_64 random(12);
        for (int n = 0; n < 200; ++n) {
            const Polygon path(random, 0.97, 1.08, 43 * degree);
            const auto work = walk<elastic>(elastic_kevlar129(), path, (50 << halving) * path.legs());
            largest[halving] = std::max(largest[halving], std::abs(work.share()));
        }
    }
    // 4 +- 1 %: the next term of the error is smaller by (1/50)^2 at the coarsest step already
    for (std::size_t halving = 1; halving < largest.size(); ++halving)
        EXPECT_NEAR(largest[halving - 1] / largest[halving], 4, 0.04) << "halving " << halving;
    EXPECT_LT(largest[0], 1e-3);
}

/// Walks 10^4 random paths, smooth and polygonal in turn, with the parts of F. The rule is of order two, or
/// one where packing and slip begin and end: its error with 2n steps is a third of the difference to n steps,
/// or at most the difference. Rounding adds one part in 10^16 a step. What a path leaves may fall below zero
/// by no more than these.
template <fabric::Features F>
void expect_only_losses(int least_dissipating) {
    std::mt19937_64 random(13);
    const auto fabric = elastic_kevlar129();
    int dissipating = 0;
    const auto check = [&](const auto& path, int steps, int n) {
        const ClosedWork coarse = walk<F>(fabric, path, steps), fine = walk<F>(fabric, path, 2 * steps);
        const double error = std::abs(coarse.left - fine.left) + 2 * steps * 1e-16 * fine.peak;
        EXPECT_GT(fine.left, -error) << "path " << n;
        EXPECT_LT(error, 0.1 * fine.peak) << "path " << n << ": too coarse to tell";
        if (fine.left > 1e-3 * fine.peak) ++dissipating;
    };
    for (int n = 0; n < 10000; n += 2) {
        check(SmoothPath(random, 0.04, 43 * degree), 200, n);
        check(Polygon(random, 0.97, 1.08, 43 * degree), 500, n + 1);
    }
    EXPECT_GT(dissipating, least_dissipating);  // the paths do lock and rub
}

TEST(ClosedPath, PackingOnlyTakesEnergy) {
    expect_only_losses<fabric::Features{.formulation = consistent, .crimp = true, .lateral = true}>(1000);
}
TEST(ClosedPath, FrictionOnlyTakesEnergy) {
    expect_only_losses<fabric::Features{.formulation = consistent, .crimp = true, .friction = true}>(9000);
}
TEST(ClosedPath, PackingAndFrictionOnlyTakeEnergy) {
    expect_only_losses<fabric::Features{
        .formulation = consistent, .crimp = true, .lateral = true, .friction = true}>(9000);
}

TEST(ClosedPath, ViscousYarnsOnlyTakeEnergy) {
    constexpr fabric::Features F{.formulation = consistent, .crimp = true, .viscous = true};
    std::mt19937_64 random(17);
    for (int n = 0; n < 1000; ++n) {
        const SmoothPath path(random, 0.04, 43 * degree);
        MaterialPoint<F> point(kevlar129(), 1e-6);
        for (int i = 1; i <= 200; ++i) point.advance(path.at(i / 200.0));
        ASSERT_GT(point.state.work, 0) << n;
    }
}

// What the print makes: bounds on the numbers of closed_path.md, so that a change of the paper formulation is
// noticed.

/// Work that the print leaves over the largest that the consistent formulation needs on the same path.
template <bool lateral = false>
double left_as_printed(const Polygon& path, int cycles = 1) {
    constexpr fabric::Features ours{.formulation = consistent, .crimp = true, .lateral = lateral};
    constexpr fabric::Features printed{.formulation = paper, .crimp = true, .lateral = lateral};
    const int steps = 2000 * path.legs();
    return walk<printed>(elastic_kevlar129(), path, steps, cycles).left /
           walk<ours>(elastic_kevlar129(), path, steps).peak;
}

TEST(ClosedPath, AsPrintedTheWayBackDiffers) {
    // the printed stress uses the initial span and no crimp angle
    EXPECT_GT(left_as_printed(stretch_shear_release_unshear()), 0.25);
    EXPECT_LT(left_as_printed(shear_stretch_unshear_release()), -0.25);
    EXPECT_LT(left_as_printed(crimp_interchange()), -0.08);
    EXPECT_GT(left_as_printed(crimp_interchange_backwards()), 0.08);
}

TEST(ClosedPath, AsPrintedStressLeftInAnOpenTrellisMakesEnergyInEveryCycle) {
    EXPECT_LT(left_as_printed<true>(stretch_lock_release_unlock(), 1), -0.02);
    EXPECT_LT(left_as_printed<true>(stretch_lock_release_unlock(), 10), -0.2);
}

}  // namespace
}  // namespace weavefront::test
