/// What the machine can do at best: bytes from memory and vector arithmetic.

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "weavefront/simd/pack.hpp"

namespace weavefront::benchmark {
namespace {

/// a = b + 3 c over arrays far larger than any cache. Bytes are those that the loop names, two read and one
/// written a value.
void triad(::benchmark::State& state) {
    const std::size_t size = std::size_t{8} << 20;
    std::vector<double> a(size, 1), b(size, 2), c(size, 3);
    for (auto _ : state) {
        const double* from_b = b.data();
        const double* from_c = c.data();
        double* to = a.data();
        for (std::size_t i = 0; i < size; ++i) to[i] = from_b[i] + 3.0 * from_c[i];
        ::benchmark::DoNotOptimize(to);
        ::benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(3 * sizeof(double) * size));
}
BENCHMARK(triad);

/// Independent multiplications and additions of whole registers, as many of each: the most arithmetic
/// instructions in a second.
void arithmetic(::benchmark::State& state) {
    constexpr int chains = 6, rounds = 1000;
    std::array<simd::Register, chains> products, sums;
    products.fill(1.0 - simd::Register{});
    sums.fill(0.0 - simd::Register{});
    double factor_value = 1.0, term_value = 1e-3;
    ::benchmark::DoNotOptimize(factor_value);
    ::benchmark::DoNotOptimize(term_value);
    const simd::Register factor = factor_value - simd::Register{}, term = term_value - simd::Register{};
    for (auto _ : state) {
        auto p = products;
        auto s = sums;
        for (int round = 0; round < rounds; ++round) {
            for (auto& value : p) value *= factor;
            for (auto& value : s) value += term;
        }
        ::benchmark::DoNotOptimize(p);
        ::benchmark::DoNotOptimize(s);
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t{2} * chains * rounds);
}
BENCHMARK(arithmetic);

}  // namespace
}  // namespace weavefront::benchmark
