/// Conversions between packs of doubles and of integers: the bits of the conversions of one number.

#include "weavefront/simd/integers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace weavefront::simd {
namespace {

/// Halves, whole numbers and their neighbours around every power of two up to 2^54, and random numbers of
/// every size up to there.
std::vector<double> numbers() {
    std::vector<double> result{0.0, -0.0, 5e-324, 0x1p-1022, 0x1p54, -0x1p54};
    for (int exponent = -2; exponent <= 54; ++exponent)
        for (int quarters = -8; quarters <= 8; ++quarters) {
            const double value = std::ldexp(1.0, exponent) + quarters * 0.25;
            for (const double near : {value, std::nextafter(value, 1e300), std::nextafter(value, -1e300)})
                if (std::abs(near) <= 0x1p54) result.insert(result.end(), {near, -near});
        }
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> mantissa(-1, 1);
    std::uniform_int_distribution<int> exponent(-10, 54);
    for (int n = 0; n < 100000; ++n) {
        const double value = std::ldexp(mantissa(random), exponent(random));
        result.push_back(value);
        result.push_back(std::abs(value) < 0x1p51 ? std::floor(value) + 0.5 : value);
    }
    while (result.size() % pack_width != 0) result.push_back(0.5);
    return result;
}

TEST(Integers, AreTheNearestWithHalvesToEven) {
    const auto values = numbers();
    for (std::size_t i = 0; i < values.size(); i += pack_width) {
        alignas(64) std::array<std::int64_t, pack_width> whole{};
        nearest(Pack::load_anywhere(&values[i])).store(whole.data());
        for (std::size_t lane = 0; lane < pack_width; ++lane)
            ASSERT_EQ(whole[lane], std::llrint(values[i + lane])) << std::hexfloat << values[i + lane];
    }
}

// The forces of a diverging element, before its fault is noticed. Sanitizers find overflows that are none of
// wrapping numbers.
TEST(Integers, WrapBeyondTheirRange) {
    alignas(64) const std::array<double, pack_width> values{1e300, -1e300, 0x1p62, -0x1p62,
                                                            3,     -7,     1e25,   -0x1p63};
    alignas(64) std::array<std::int64_t, pack_width> whole{}, sum{};
    const auto integers = nearest(Pack::load(values.data()));
    integers.store(whole.data());
    (-(integers + integers + integers)).store(sum.data());
    for (std::size_t lane = 0; lane < pack_width; ++lane)
        EXPECT_EQ(static_cast<std::uint64_t>(sum[lane]), 0 - 3 * static_cast<std::uint64_t>(whole[lane]))
            << values[lane];
}

TEST(Integers, BecomeTheNearestDoubles) {
    using Limits = std::numeric_limits<std::int64_t>;
    std::vector<std::int64_t> values{
        0, 1, -1, Limits::max(), Limits::min(), Limits::max() - 1, Limits::min() + 1};
    for (int bit = 0; bit < 63; ++bit)
        for (std::int64_t offset = -3; offset <= 3; ++offset)
            values.insert(values.end(),
                          {(std::int64_t{1} << bit) + offset, -(std::int64_t{1} << bit) + offset});
    std::mt19937_64 random(6);
    for (int n = 0; n < 100000; ++n) values.push_back(static_cast<std::int64_t>(random()) >> n % 64);
    while (values.size() % pack_width != 0) values.push_back(7);
    for (std::size_t i = 0; i < values.size(); i += pack_width) {
        const Pack doubles = to_pack(Integers::load(&values[i]));
        for (std::size_t lane = 0; lane < pack_width; ++lane)
            ASSERT_EQ(doubles.get(static_cast<int>(lane)), static_cast<double>(values[i + lane]))
                << values[i + lane];
    }
}

}  // namespace
}  // namespace weavefront::simd
