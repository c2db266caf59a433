#include "weavefront/simd/pack.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "weavefront/simd/math.hpp"

namespace weavefront::simd {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Pack pack_of(const std::array<double, 8>& values) {
    Pack pack;
    for (int i = 0; i < 8; ++i) pack.set(i, values[static_cast<std::size_t>(i)]);
    return pack;
}

/// Pairs of awkward and of random operands, eight at a time.
std::vector<std::array<std::array<double, 8>, 2>> operands() {
    const std::vector<double> awkward{0.0,       -0.0,         1.0,    -1.0,  infinity,
                                      -infinity, not_a_number, 1e-310, 1e308, 3.0};
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> mantissa(-2, 2);
    std::uniform_int_distribution<int> exponent(-300, 300);
    std::uniform_int_distribution<std::size_t> pick(0, 2 * awkward.size());
    const auto draw = [&] {
        const std::size_t i = pick(random);
        return i < awkward.size() ? awkward[i] : std::ldexp(mantissa(random), exponent(random));
    };
    std::vector<std::array<std::array<double, 8>, 2>> result(5000);
    for (auto& pair : result) {
        for (auto& side : pair) {
            for (double& value : side) value = draw();
        }
    }
    return result;
}

/// Compares `packed` with `scalar` of each lane bit by bit; any two NaN are equal.
template <class Packed, class Scalar>
void expect_same_bits(Packed packed, Scalar scalar) {
    for (const auto& [a, b] : operands()) {
        const Pack result = packed(pack_of(a), pack_of(b));
        for (std::size_t i = 0; i < 8; ++i) {
            const double expected = scalar(a[i], b[i]);
            const double got = result.get(static_cast<int>(i));
            if (std::isnan(expected) && std::isnan(got)) continue;
            ASSERT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(expected))
                << a[i] << ' ' << b[i];
        }
    }
}

#define SAME_BITS(expression)                                                                          \
    expect_same_bits([](const Pack& a, [[maybe_unused]] const Pack& b) -> Pack { return expression; }, \
                     [](double a, [[maybe_unused]] double b) -> double { return expression; })

TEST(Pack, GivesTheBitsOfDoubleInEveryLane) {
    SAME_BITS(a + b);
    SAME_BITS(a - b);
    SAME_BITS(a * b);
    SAME_BITS(a / b);
    SAME_BITS(-a);
    SAME_BITS(sqrt(abs(a)));
    SAME_BITS(abs(a));
    SAME_BITS(min(a, b));
    SAME_BITS(max(a, b));
    SAME_BITS(select(a < b, a, b));
    SAME_BITS(select(a <= b, b, a));
    SAME_BITS(select(a > b, a, b));
    SAME_BITS(select(a >= b, b, a));
    SAME_BITS(select(a == b, b, a));
    SAME_BITS(select((a < b) & (b < 1.0), a, b));
    SAME_BITS(select((a < b) | (b < 1.0), a, b));
    SAME_BITS(select(!(a < b), a, b));
    SAME_BITS(clamp(a, -abs(b), abs(b)));
}

TEST(Pack, FunctionsChooseTheirWayLaneByLane) {
    const auto tangent = [](const auto& x) { return atan(x); };
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> inside(-1, 1), size(-40, 40);
    for (int n = 0; n < 2000; ++n) {
        std::array<double, 8> x{}, a{}, b{};
        for (std::size_t i = 0; i < 8; ++i) {
            x[i] = i == 0 ? inside(random) : 0.1 * inside(random);  // one lane goes the long way
            a[i] = std::exp(size(random));
            b[i] = i == 0 ? std::exp(size(random)) : a[i] * (1 + 0.01 * inside(random));
        }
        const Pack angles = tangent(pack_of(x)), logarithms = log_ratio(pack_of(a), pack_of(b));
        for (int i = 0; i < 8; ++i) {
            const auto k = static_cast<std::size_t>(i);
            ASSERT_EQ(angles.get(i), tangent(x[k]));
            ASSERT_EQ(logarithms.get(i), log_ratio(a[k], b[k]));
        }
    }
}

TEST(Pack, AnyAndAllLookAtEveryLane) {
    EXPECT_FALSE(any(Pack(1.0) < Pack(0.0)));
    EXPECT_TRUE(all(Pack(0.0) < Pack(1.0)));
    for (int i = 0; i < 8; ++i) {
        Pack one = 1.0;
        one.set(i, -1.0);
        EXPECT_TRUE(any(one < 0.0));
        EXPECT_FALSE(all(one < 0.0));
        EXPECT_FALSE(all(one > 0.0));
    }
}

TEST(Pack, LoadsAndStoresInLaneOrder) {
    alignas(64) std::array<double, 8> from{1, 2, 3, 4, 5, 6, 7, 8}, to{};
    const Pack pack = Pack::load(from.data());
    EXPECT_EQ(pack.get(0), 1);
    EXPECT_EQ(pack.get(7), 8);
    pack.store(to.data());
    EXPECT_EQ(to, from);
}

}  // namespace
}  // namespace weavefront::simd
