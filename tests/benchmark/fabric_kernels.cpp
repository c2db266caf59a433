/// The fabric's kernels: one point at a time, as the tests do, against packs of eight, as the product does.

#include <benchmark/benchmark.h>

#include <vector>

#include "../fabric/kevlar129.hpp"
#include "kernels.hpp"
#include "weavefront/fabric/cell.hpp"
#include "weavefront/shell/aligned_vector.hpp"
#include "weavefront/simd/pack.hpp"

namespace weavefront::benchmark {
namespace {

using simd::Pack;
constexpr fabric::Features full{.formulation = scene::Formulation::consistent,
                                .crimp = true,
                                .viscous = true,
                                .lateral = true,
                                .friction = true,
                                .failure = true};
constexpr double dt = 1e-8;

/// A value a point, from which either number type takes its own.
using Values = shell::AlignedVector<double>;

Values draw(std::mt19937_64& random, double a, double b) {
    Values values(batch);
    for (double& value : values) value = uniform(random, a, b);
    return values;
}

/// Yarns as an impact leaves them: stretched by up to 6 %, half way between fill and warp taking up the
/// crimp.
struct Crossovers {
    std::mt19937_64 random{3};
    Values stretch_f = draw(random, 1, 1.06), stretch_w = draw(random, 0.99, 1.01),
           height = draw(random, 0.1, 0.3);
    Values stress_f = draw(random, 0, 2e9), stress_w = draw(random, 0, 5e8);
};

template <class Real>
void crimp(::benchmark::State& state) {
    const Crossovers drawn;
    const auto c = fabric::constants_of(test::kevlar129());
    const auto step = fabric::step_of(c, full, dt);
    Values rises(batch);
    for (auto _ : state) {
        for (std::size_t at = 0; at < batch; at += simd::width<Real>) {
            const auto load = [at](const Values& values) {
                return simd::RealTraits<Real>::load(values.data() + at);
            };
            const Real h_f = c.thickness * load(drawn.height), h_w = 0.5 * c.thickness - h_f,
                       half_span = 0.5 * c.fill.span;
            const Real a_f = half_span * load(drawn.stretch_f), a_w = half_span * load(drawn.stretch_w),
                       slope = step.fill.modulus * c.fill.inverse_length;
            const fabric::EndBalance<Real> balance{
                {.a_f = a_f,
                 .a_w = a_w,
                 .h_f = h_f,
                 .h_w = h_w,
                 .law_f = {load(drawn.stress_f), slope, fabric::bar_length(a_f, h_f)},
                 .law_w = {load(drawn.stress_w), slope, fabric::bar_length(a_w, h_w)}}};
            const Real rise = fabric::balance_crossover(balance, Real(-h_f), h_w, 0.5 * c.thickness);
            simd::RealTraits<Real>::store(rise, rises.data() + at);
        }
        ::benchmark::DoNotOptimize(rises.data());
        ::benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch));
}
BENCHMARK_TEMPLATE(crimp, double)->Name("crimp/scalar");
BENCHMARK_TEMPLATE(crimp, Pack)->Name("crimp/pack");

/// Stretches and angles that go to and fro; nothing breaks.
struct Paths {
    std::mt19937_64 random{4};
    Values stretch_f = draw(random, 1, 1.01), stretch_w = draw(random, 1, 1.005),
           cos_2theta = draw(random, -0.6, 0.6);
};

template <class Real>
void cell(::benchmark::State& state) {
    const Paths paths;
    const auto c = fabric::constants_of(test::kevlar129());
    const auto step = fabric::step_of(c, full, dt);
    constexpr std::size_t fields = fabric::state_size<full>();
    Values states(batch * fields), resultants(batch);
    for (std::size_t at = 0; at < batch; at += simd::width<Real>)
        fabric::store_state<full, Real>(fabric::initial_state<full, Real>(c), states.data() + at * fields);
    double there = 1e-5;
    for (auto _ : state) {
        there = -there;
        for (std::size_t at = 0; at < batch; at += simd::width<Real>) {
            const auto load = [at](const Values& values) {
                return simd::RealTraits<Real>::load(values.data() + at);
            };
            auto point = fabric::load_state<full, Real>(states.data() + at * fields);
            const auto response =
                fabric::advance<full, Real>(c, step, point, load(paths.stretch_f) + there,
                                            load(paths.stretch_w) - there, load(paths.cos_2theta) + there);
            fabric::store_state<full, Real>(point, states.data() + at * fields);
            simd::RealTraits<Real>::store(response.T_xx, resultants.data() + at);
        }
        ::benchmark::DoNotOptimize(resultants.data());
        ::benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch));
}
BENCHMARK_TEMPLATE(cell, double)->Name("cell/scalar");
BENCHMARK_TEMPLATE(cell, Pack)->Name("cell/pack");

}  // namespace
}  // namespace weavefront::benchmark
