#pragma once
/// @file
/// Random numbers for tests of shapes.

#include <random>

namespace weavefront::test {

[[nodiscard]] inline double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

}  // namespace weavefront::test
