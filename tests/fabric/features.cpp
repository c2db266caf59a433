/// Every feature set: scalar and packed give the same bits, and nothing that is not finite comes out of
/// finite stretches.

#include "weavefront/fabric/features.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "material_point.hpp"
#include "weavefront/fabric/stiffness.hpp"
#include "weavefront/simd/pack.hpp"

namespace weavefront::test {
namespace {

using fabric::Features;
using simd::Pack;

/// Kevlar with what `features` names and nothing else.
scene::Fabric fabric_with(const Features& features) {
    scene::Fabric result = features.unequal ? unequal_kevlar129() : kevlar129();
    result.formulation = features.formulation;
    if (!features.crimp) result.thickness = 0;
    if (!features.viscous) result.elastic.viscosity = 0;
    if (!features.lateral) result.lateral.reset();
    if (!features.friction) result.friction = 0;
    if (!features.failure) result.failure.reset();
    if (features.scatter) result.failure->scatter = scene::Scatter{20, 0.2, 1};
    return result;
}

/// Stretches and angle cosines of a step: mild for most, absurd for some.
struct Inputs {
    std::mt19937_64 random;
    double draw(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
    double stretch(int lane) {
        if (lane % 4 == 3 && draw(0, 1) < 0.05) return std::exp(draw(-700, 700));
        return draw(0.95, lane % 2 == 0 ? 1.06 : 1.3);
    }
    double cosine(int lane) {
        if (lane % 4 == 3 && draw(0, 1) < 0.05) return draw(0, 1) < 0.5 ? 1.0 : -1.0;
        return draw(-1, 1) * (lane % 3 == 0 ? 1.0 : 0.3);
    }
};

/// All numbers of a response, and of the bound after it.
template <Features F, class Real>
std::array<Real, 9> outcome(const fabric::Constants& c, const fabric::Step& step, fabric::State<Real>& state,
                            const Real& f, const Real& w, const Real& cosine) {
    const fabric::Response<Real> r = fabric::advance<F, Real>(c, step, state, f, w, cosine);
    const fabric::Stiffness<Real> k = fabric::stiffness_bound<F>(c, state);
    return {r.T_xx, r.T_yy, r.T_xy, r.sin_theta, r.cos_theta, k.yarn_f, k.yarn_w, k.lateral, k.angle};
}

/// The stored doubles of a state.
template <Features F>
struct Stored {
    static constexpr int fields = fabric::state_size<F>();
    alignas(64) std::array<double, 8 * fields> packed{};
    std::array<std::array<double, fields>, 8> lanes{};

    [[nodiscard]] bool same() const {
        for (std::size_t i = 0; i < fields; ++i) {
            for (std::size_t l = 0; l < 8; ++l) {
                if (std::memcmp(&packed[8 * i + l], &lanes[l][i], sizeof(double)) != 0) return false;
            }
        }
        return true;
    }
    [[nodiscard]] bool finite() const {
        for (const double value : packed) {
            if (!std::isfinite(value)) return false;
        }
        return true;
    }
};

template <Features F>
void check_kernel(double dt, unsigned seed) {
    const scene::Fabric described = fabric_with(F);
    ASSERT_TRUE(fabric::features_of(described) == F);
    const fabric::Constants c = fabric::constants_of(described);
    const fabric::Step step = fabric::step_of(c, F, dt);
    Inputs inputs{std::mt19937_64(seed)};
    Stored<F> stored;
    fabric::store_state<F, Pack>(fabric::initial_state<F, Pack>(c), stored.packed.data());
    for (auto& lane : stored.lanes)
        fabric::store_state<F, double>(fabric::initial_state<F, double>(c), lane.data());
    for (int n = 0; n < 400; ++n) {
        Pack f, w, cosine;
        for (int l = 0; l < 8; ++l) {
            f.set(l, inputs.stretch(l));
            w.set(l, inputs.stretch(l));
            cosine.set(l, inputs.cosine(l));
        }
        auto state = fabric::load_state<F, Pack>(stored.packed.data());
        const std::array<Pack, 9> result = outcome<F>(c, step, state, f, w, cosine);
        fabric::store_state<F, Pack>(state, stored.packed.data());
        for (int l = 0; l < 8; ++l) {
            double* lane = stored.lanes[static_cast<std::size_t>(l)].data();
            auto scalar = fabric::load_state<F, double>(lane);
            const std::array<double, 9> expected =
                outcome<F>(c, step, scalar, f.get(l), w.get(l), cosine.get(l));
            fabric::store_state<F, double>(scalar, lane);
            for (std::size_t i = 0; i < 9; ++i) {
                const double got = result[i].get(l);
                ASSERT_EQ(std::memcmp(&got, &expected[i], sizeof got), 0)
                    << "step " << n << " lane " << l << " result " << i;
                ASSERT_TRUE(std::isfinite(got)) << "step " << n << " lane " << l << " result " << i
                                                << " lambda " << f.get(l) << ' ' << w.get(l);
            }
        }
        ASSERT_TRUE(stored.same()) << "step " << n;
        ASSERT_TRUE(stored.finite()) << "step " << n;
    }
}

template <int index = 0>
void for_each_feature_set() {
    constexpr Features F = fabric::feature_set(index);
    SCOPED_TRACE(::testing::Message() << "feature set " << index);
    check_kernel<F>(1e-7, 23);
    check_kernel<F>(1e3, 29);
    if constexpr (index + 1 < fabric::feature_sets) {
        if (!::testing::Test::HasFatalFailure()) for_each_feature_set<index + 1>();
    }
}

TEST(Features, EveryKernelGivesTheSameBitsScalarAndPacked) { for_each_feature_set(); }

TEST(Features, WhatIsNotAskedForHasNoState) {
    constexpr Features least{.formulation = consistent};
    EXPECT_EQ(fabric::state_size<least>(), 5);  // stretches, forces and work
    constexpr Features most{.formulation = consistent,
                            .crimp = true,
                            .viscous = true,
                            .lateral = true,
                            .friction = true,
                            .failure = true};
    EXPECT_EQ(fabric::state_size<most>(), 20);
    scene::Fabric straight = kevlar129();
    straight.thickness = 0;
    EXPECT_FALSE(fabric::features_of(straight).friction);
}

TEST(Features, EachSetIsReachedFromItsFabric) {
    for (int i = 0; i < fabric::feature_sets; ++i) {
        const Features features = fabric::features_of(fabric_with(fabric::feature_set(i)));
        EXPECT_TRUE(fabric::with_features(features, [&features]<Features F>() { return F == features; }));
    }
}

TEST(Features, LeavingOutWhatDoesNotActChangesNoBit) {
    // no turn, no failure strain reached, trellis open: the full kernel and the bare one agree
    constexpr Features most{.formulation = consistent,
                            .crimp = true,
                            .viscous = true,
                            .lateral = true,
                            .friction = true,
                            .failure = true};
    constexpr Features bare{.formulation = consistent, .crimp = true, .viscous = true};
    MaterialPoint<most> full(kevlar129(), 1e-7);
    MaterialPoint<bare> least(kevlar129(), 1e-7);
    for (int i = 1; i <= 100; ++i) {
        const Kinematics k{.lambda_f = 1 + 2e-4 * i, .lambda_w = 1 + 1e-4 * i};
        const fabric::Response<double> a = full.advance(k), b = least.advance(k);
        ASSERT_EQ(a.T_xx, b.T_xx);
        ASSERT_EQ(a.T_xy, b.T_xy);
        ASSERT_EQ(full.state.work, least.state.work);
    }
}

TEST(Features, WhatIsNotANumberComesThrough) {
    // a guard can only find what the kernel does not swallow
    constexpr Features F{.formulation = consistent,
                         .crimp = true,
                         .viscous = true,
                         .lateral = true,
                         .friction = true,
                         .failure = true};
    MaterialPoint<F> point(kevlar129(), 1e-7);
    EXPECT_TRUE(std::isnan(point.advance({.lambda_f = NAN}).T_xx));
}

}  // namespace
}  // namespace weavefront::test
