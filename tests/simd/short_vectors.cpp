#include "weavefront/simd/short_vectors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace weavefront::simd {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 4> left{-1.5, 0.1, nan, -infinity}, right{2.5, -0.1, 3, 7};

TEST(ShortVectors, ComputeEachNumberAsADouble) {
    const auto a = load<Double4>(left.data()), b = load<Double4>(right.data());
    const Double4 least = min(a, b), most = max(a, b), size = abs(a);
    for (int i = 0; i < 4; ++i) {
        const double x = left[static_cast<std::size_t>(i)], y = right[static_cast<std::size_t>(i)];
        EXPECT_EQ(least[i], min(x, y)) << i;
        EXPECT_EQ(most[i], max(x, y)) << i;
        if (i != 2) {
            EXPECT_EQ(size[i], std::abs(x)) << i;
        }
    }
    EXPECT_TRUE(std::isnan(size[2]));
}

TEST(ShortVectors, JoinAndWidenInOrder) {
    const std::array<double, 5> values{1, 2, 3, 4, 5};
    const Double4 whole = joined(load<Double2>(values.data() + 1), load<Double2>(values.data() + 3));
    const std::array<float, 4> floats{0.1F, -0.2F, 3e38F, 1e-45F};
    const Double4 wide = widened(load<Float4>(floats.data()));
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(whole[i], i + 2);
        EXPECT_EQ(wide[i], static_cast<double>(floats[static_cast<std::size_t>(i)]));
    }
}

TEST(ShortVectors, FindAnyTruth) {
    const Double4 zero{};
    for (int i = 0; i < 4; ++i) {
        Double4 one{};
        one[i] = 1;
        EXPECT_TRUE(any(one > zero)) << i;
    }
    EXPECT_FALSE(any(zero > zero));
}

}  // namespace
}  // namespace weavefront::simd
