/// Vectors in memory and packs of their components.

#include "weavefront/simd/vectors.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace weavefront::simd {
namespace {

TEST(Vectors, AreGatheredByComponent) {
    std::vector<double> vectors(std::size_t{3} * 20);
    std::iota(vectors.begin(), vectors.end(), 0.0);
    const std::array<std::int32_t, pack_width> index{
        19, 0, 7, 7, 3, 12, 1, 18};  // the last and the first: nothing beyond is read
    const auto components = gather_vectors(vectors.data(), index);
    for (std::size_t d = 0; d < 3; ++d)
        for (int lane = 0; lane < pack_width; ++lane)
            EXPECT_EQ(components[d].get(lane),
                      3 * index[static_cast<std::size_t>(lane)] + static_cast<int>(d))
                << lane;
}

template <int block>
void expect_spread() {
    Pack of_vectors;
    for (int n = 0; n < pack_width; ++n) of_vectors.set(n, 10.0 + n);
    for (int lane = 0; lane < pack_width; ++lane) {
        const int vector = (block * pack_width + lane) / 3;
        EXPECT_EQ(spread<block>(of_vectors).get(lane), 10.0 + vector) << block << ' ' << lane;
    }
}

TEST(Vectors, ShareOneNumberAmongTheirComponents) {
    expect_spread<0>();
    expect_spread<1>();
    expect_spread<2>();
}

}  // namespace
}  // namespace weavefront::simd
