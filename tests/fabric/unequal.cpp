/// Fabrics whose fill and warp differ.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "closed_paths.hpp"

namespace weavefront::test {
namespace {

constexpr auto unequal = fabric::any_unequal_fabric;

/// A fabric with fill and warp exchanged.
scene::Fabric exchanged(const scene::Fabric& fabric) {
    scene::Fabric result = fabric;
    auto& warp = *result.warp;
    std::swap(result.yarn, warp.yarn);
    std::swap(result.elastic, warp.elastic);
    std::swap(warp.crimp_height, warp.fill_crimp_height);
    if (result.failure) {
        std::swap(result.failure->static_strain, warp.strength.static_strain);
        std::swap(result.failure->hooke_strain, warp.strength.hooke_strain);
    }
    return result;
}

/// Without packing and friction, which take energy.
scene::Fabric open_trellis() {
    auto fabric = elastic(unequal_kevlar129());
    fabric.lateral.reset();
    fabric.friction = 0;
    return fabric;
}

/// Largest difference of resultants and works of two cells along one path, over their size.
template <fabric::Features F, fabric::Features G, class Turned>
double largest_difference(const scene::Fabric& one, const scene::Fabric& other, Turned turned) {
    std::mt19937_64 random(31);
    double largest = 0;
    for (int n = 0; n < 50; ++n) {
        const SmoothPath path(random, 0.02, 43 * degree);
        MaterialPoint<F> a(one, 1e-8);
        MaterialPoint<G> b(other, 1e-8);
        double size = 0, off = 0;
        for (int i = 1; i <= 400; ++i) {
            const auto k = path.at(i / 400.0);
            const auto [k_turned, sign] = turned(k);
            const auto at_a = a.advance(k), at_b = b.advance(k_turned);
            size = std::max({size, std::abs(at_a.T_xx), std::abs(at_a.T_yy), std::abs(at_a.T_xy)});
            off = std::max({off, std::abs(at_a.T_xx - at_b.T_xx), std::abs(at_a.T_yy - at_b.T_yy),
                            std::abs(at_a.T_xy - sign * at_b.T_xy)});
        }
        largest = std::max({largest, off / size, std::abs(a.state.work / b.state.work - 1),
                            std::abs(a.state.friction_work / b.state.friction_work - 1)});
    }
    return largest;
}

TEST(Unequal, EqualYarnsAreTheSpecialCase) {
    constexpr fabric::Features equal{.formulation = consistent,
                                     .crimp = true,
                                     .viscous = true,
                                     .lateral = true,
                                     .friction = true,
                                     .failure = true};
    const auto same = [](const Kinematics& k) { return std::pair{k, 1.0}; };
    // only the friction arm is computed in another way: rounding
    EXPECT_LT((largest_difference<equal, unequal>(kevlar129(), kevlar129(), same)), 1e-12);
}

TEST(Unequal, ExchangedFillAndWarpTurnedBy90DegreesAreTheSameFabric) {
    // the mirror image: what was the fill at +theta is the warp at -theta
    const auto mirrored = [](const Kinematics& k) {
        return std::pair{Kinematics{.lambda_f = k.lambda_w, .lambda_w = k.lambda_f, .theta = k.theta}, -1.0};
    };
    // heights are rounded by 1e-16 of t/2 in either cell; stresses differ by that times E over the span
    EXPECT_LT(
        (largest_difference<unequal, unequal>(unequal_kevlar129(), exchanged(unequal_kevlar129()), mirrored)),
        1e-11);
}

TEST(Unequal, ForcesBalanceAtTheCrossover) {
    auto fabric = unequal_kevlar129();
    fabric.failure.reset();
    MaterialPoint<unequal> point(fabric, 1e-7);
    const auto& c = point.constants;
    for (int i = 1; i <= 300; ++i) {
        point.advance({.lambda_f = 1 + 2e-4 * i, .lambda_w = 1 + 3e-4 * i});
        const auto& s = point.state;
        const auto L = fabric::bar_lengths<unequal>(c, s);
        const double press_f = c.fill.area * s.sigma_f * s.h_f / L.fill,
                     press_w = c.warp.area * s.sigma_w * (c.thickness / 2 - s.h_f) / L.warp;
        // the last Newton step leaves rounding of the heights and of the strains
        EXPECT_NEAR(press_f, press_w, 1e-14 * c.fill.hooke_modulus * c.fill.area) << i;
    }
}

TEST(Unequal, StraightYarnsCarryTheirOwnModulusAreaAndDistance) {
    auto fabric = open_trellis();
    fabric.thickness = fabric.warp->crimp_height = fabric.warp->fill_crimp_height = 0;
    MaterialPoint<unequal> point(fabric, 1e-9);
    point.advance({.lambda_f = 1.01, .lambda_w = 1.02});
    // the fill lies every span of the warp
    EXPECT_NEAR(point.state.N_f, 96e9 * 0.01 * 6.48e-8 / 0.8e-3, 1e-9);
    EXPECT_NEAR(point.state.N_w, 80e9 * 0.02 * 8.1e-8 / 0.909e-3, 1e-9);
}

TEST(Unequal, NothingIsStressedAtRest) {
    MaterialPoint<unequal> point(unequal_kevlar129(), 1e-7);
    const auto response = point.advance({});
    EXPECT_EQ(response.T_xx, 0);
    EXPECT_EQ(response.T_yy, 0);
    EXPECT_EQ(point.state.h_f, 0.10e-3);
}

/// Yarns that do not stretch: pulling the warp straight crimps the fill, h_w and h_f on the circles of their
/// lengths, and h_f + h_w = t/2.
double fill_stretch_of(const fabric::Constants& c, double lambda_w, double& h_f) {
    const double a_w = lambda_w * c.warp.span / 2;
    h_f = c.thickness / 2 - std::sqrt(std::max(0.0, c.warp.length * c.warp.length - a_w * a_w));
    return 2 * std::sqrt(c.fill.length * c.fill.length - h_f * h_f) / c.fill.span;
}

void expect_crimp_interchange(const scene::Fabric& fabric) {
    MaterialPoint<unequal> point(fabric, 1e-9);
    const auto& c = point.constants;
    const double slack = 2 * c.warp.length / c.warp.span, stiffness = 96e9 * 6.48e-8 / 0.8e-3;
    const int steps = 400;
    for (int i = 1; i <= steps; ++i) {
        const double lambda_w = 1 + (slack - 1) * i / steps;
        double h_f = 0;
        const double lambda_f = fill_stretch_of(c, lambda_w, h_f);
        point.advance({.lambda_f = lambda_f, .lambda_w = lambda_w});
        // h_w is the square root of slack: rounding of the stretches, 1e-16, leaves 1e-8 of the height
        EXPECT_NEAR(point.state.h_f, h_f, 1e-7 * c.thickness) << i;
    }
    EXPECT_NEAR(point.state.h_f, c.thickness / 2, 1e-7 * c.thickness);
    EXPECT_NEAR(point.state.N_w, 0, 1e-9 * stiffness);
    EXPECT_NEAR(point.state.N_f, 0, 1e-9 * stiffness);
}

TEST(Unequal, PullingTheWarpStraightCrimpsTheFill) { expect_crimp_interchange(open_trellis()); }

TEST(Unequal, AStraightFillTakesUpTheCrimpOfTheWarp) {
    auto fabric = open_trellis();
    fabric.warp->crimp_height += std::exchange(fabric.warp->fill_crimp_height, 0);
    expect_crimp_interchange(fabric);
}

TEST(Unequal, AStraightFillPressesNoWarp) {
    // it takes all of a stretch at once, and presses the warp nowhere
    auto fabric = open_trellis();
    fabric.warp->crimp_height += std::exchange(fabric.warp->fill_crimp_height, 0);
    MaterialPoint<unequal> point(fabric, 1e-9);
    point.advance({.lambda_f = 1.01});
    EXPECT_EQ(point.state.h_f, 0);
    EXPECT_NEAR(point.state.N_f, 96e9 * 0.01 * 6.48e-8 / 0.8e-3, 1e-9);
    EXPECT_EQ(point.state.N_w, 0);
}

TEST(Unequal, AnOpenTrellisReturnsEverything) {
    std::mt19937_64 random(11);
    for (int n = 0; n < 20; ++n) {
        const SmoothPath path(random, 0.05, 43 * degree);
        const ClosedWork coarse = walk<unequal>(open_trellis(), path, 400),
                         fine = walk<unequal>(open_trellis(), path, 1600);
        EXPECT_LT(std::abs(fine.left), 1e-5 * fine.peak) << n;
        // order two: a step of a quarter leaves a sixteenth, or better
        EXPECT_LT(std::abs(fine.left), std::abs(coarse.left) / 12 + 1e-12 * fine.peak) << n;
    }
}

TEST(Unequal, PackingAndFrictionOnlyTakeEnergy) {
    // as ClosedPath, on fewer paths: rule of order two or one, and rounding
    std::mt19937_64 random(13);
    const auto fabric = elastic(unequal_kevlar129());
    for (int n = 0; n < 500; ++n) {
        const SmoothPath path(random, 0.04, 43 * degree);
        const ClosedWork coarse = walk<unequal>(fabric, path, 400), fine = walk<unequal>(fabric, path, 800);
        const double error = std::abs(coarse.left - fine.left) + 800 * 1e-16 * fine.peak;
        EXPECT_GT(fine.left, -error) << n;
    }
}

TEST(Unequal, WorkEqualsTheStressPower) {
    const auto defect = [](int steps, double& power) {
        auto fabric = unequal_kevlar129();
        fabric.failure.reset();
        MaterialPoint<unequal> point(fabric, 1e-4 / steps);
        const auto path = [](double x) {
            return Kinematics{.lambda_f = 1 + 0.03 * x + 0.01 * std::sin(5 * x),
                              .lambda_w = 1 + 0.04 * x * x,
                              .theta = (45 + 42 * std::sin(1.5 * x)) * degree};
        };
        fabric::Response<double> last{};
        power = 0;
        for (int i = 1; i <= steps; ++i) {
            const auto from = path((i - 1.0) / steps), to = path(static_cast<double>(i) / steps);
            const auto at = [](const Kinematics& k) { return fabric::trellis_of(std::cos(2 * k.theta)); };
            const auto now = point.advance(to);
            const auto dE = fabric::strain_increment(from.lambda_f, from.lambda_w, at(from), to.lambda_f,
                                                     to.lambda_w, at(to));
            power += 0.5 * ((last.T_xx + now.T_xx) * dE.xx + (last.T_yy + now.T_yy) * dE.yy) +
                     (last.T_xy + now.T_xy) * dE.xy;
            last = now;
        }
        return std::abs(point.state.work + point.state.friction_work - power);
    };
    double power = 0;
    const double coarse = defect(1000, power), fine = defect(2000, power);
    EXPECT_LT(fine, 1e-4 * power);
    EXPECT_GT(std::log2(coarse / fine), 1.9);
}

TEST(Unequal, YarnsCrossInAParallelogram) {
    // the midpoint rule over the sides' coordinates; the distance is smooth but at the centre, so its error
    // is below (1/n)^2
    const double w_f = 0.32e-3, w_w = 0.45e-3;
    for (double theta = 12; theta < 80; theta += 8) {
        const double sine = std::sin(2 * theta * degree), cosine = std::cos(2 * theta * degree);
        const double a = w_w / sine, b = w_f / sine;  // sides along fill and warp
        const int n = 1000;
        double sum = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double u = ((i + 0.5) / n - 0.5) * a, v = ((j + 0.5) / n - 0.5) * b;
                sum += std::sqrt(u * u + v * v + 2 * u * v * cosine);
            }
        const double mean = fabric::mean_distance(w_f, w_w, fabric::trellis_of(cosine));
        EXPECT_NEAR(mean / (sum / n / n), 1, 2e-6) << theta;
    }
}

TEST(Unequal, TheYarnsThatTouchFirstLockTheTrellis) {
    auto fabric = unequal_kevlar129();
    fabric.lateral.reset();
    // sin(2 theta_min) = w/s (1): 0.32/0.8 of the fill, 0.45/0.909 of the warp
    EXPECT_NEAR(fabric::constants_of(fabric).packed_cos_2theta, std::cos(std::asin(0.45 / 0.909)), 1e-15);
}

TEST(Unequal, EachYarnBreaksAtItsOwnStrain) {
    auto fabric = unequal_kevlar129();
    fabric.elastic.viscosity = fabric.warp->elastic.viscosity = 0;
    fabric.thickness = fabric.warp->crimp_height = fabric.warp->fill_crimp_height = 0;
    MaterialPoint<unequal> point(fabric, 1e-7);
    point.advance({.lambda_f = 1.0329, .lambda_w = 1.0399});
    EXPECT_EQ(point.state.intact_f + point.state.intact_w, 2);
    point.advance({.lambda_f = 1.0331, .lambda_w = 1.0399});
    EXPECT_EQ(point.state.intact_f, 0);
    EXPECT_EQ(point.state.intact_w, 1);
    point.advance({.lambda_f = 1.0331, .lambda_w = 1.0401});
    EXPECT_EQ(point.state.intact_w, 0);
}

TEST(Scatter, FailureStrainsArePartsOfThoseOfTheFabric) {
    // without viscosity by (20), with a weak Hooke spring by (19): both criteria are scaled
    for (const double hooke_strain : {0.03, 0.01}) {
        auto fabric = kevlar129();
        fabric.elastic.viscosity = fabric.thickness = 0;
        fabric.failure->hooke_strain = hooke_strain;
        const double of_fabric = std::min(0.033, 2 * hooke_strain);  // Ka/E1 = 2
        for (const double strength : {0.8, 1.3}) {
            MaterialPoint<fabric::any_scattered_fabric> point(fabric, 1e-7);
            point.state.weakness_f = 1 / strength;
            const double breaks = strength * of_fabric;
            point.advance({.lambda_f = 1 + 0.999 * breaks, .lambda_w = 1 + 0.999 * of_fabric});
            EXPECT_EQ(point.state.intact_f + point.state.intact_w, 2);
            point.advance({.lambda_f = 1 + 1.001 * breaks, .lambda_w = 1 + 0.999 * of_fabric});
            EXPECT_EQ(point.state.intact_f, 0);
            EXPECT_EQ(point.state.intact_w, 1);
        }
    }
}

}  // namespace
}  // namespace weavefront::test
