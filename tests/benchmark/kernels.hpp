#pragma once
/// @file
/// What the kernel benchmarks share.

#include <cstddef>
#include <random>

namespace weavefront::benchmark {

/// Points or elements that a benchmark goes through before it begins again: their state stays in the first
/// two levels of cache.
inline constexpr std::size_t batch = 512;

[[nodiscard]] inline double uniform(std::mt19937_64& random, double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
}

}  // namespace weavefront::benchmark
