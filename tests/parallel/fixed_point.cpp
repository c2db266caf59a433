/// Sums of reals that do not depend on their order.

#include "weavefront/parallel/fixed_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::test {
namespace {

using parallel::FixedPoint;

std::vector<double> random_terms(double largest) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> sign(-1, 1), exponent(-40, 0);
    std::vector<double> terms(256);
    for (auto& term : terms) term = largest * sign(random) * std::exp2(exponent(random));
    return terms;
}

TEST(FixedPoint, SumsDoNotDependOnTheirOrder) {
    const FixedPoint scale(1e5);
    auto terms = random_terms(1e5);
    double real_sum = 0;
    for (const double term : terms) real_sum += term;
    std::int64_t first = 0;
    for (const double term : terms) first += scale.from(term);
    // each term is rounded to half a quantum
    EXPECT_NEAR(scale.to(first), real_sum, 0.5 * scale.quantum() * 256 + 256 * 2.3e-16 * 1e5);
    std::mt19937_64 random(6);
    for (int n = 0; n < 100; ++n) {
        std::ranges::shuffle(terms, random);
        std::int64_t sum = 0;
        for (const double term : terms) sum += scale.from(term);
        ASSERT_EQ(sum, first);
    }
}

TEST(FixedPoint, SumsDoNotDependOnTheRanks) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const FixedPoint scale(1e5);
    const auto terms = random_terms(1e5);
    std::int64_t alone = 0, here = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        alone += scale.from(terms[i]);
        if (static_cast<int>(i) % comm.size() == comm.rank()) here += scale.from(terms[i]);
    }
    comm.sum(std::span(&here, 1));
    EXPECT_EQ(here, alone);
}

TEST(FixedPoint, ChecksItsRange) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const double largest : {1.0, 3.7e5, 1e-7}) {
        const FixedPoint scale(largest);
        EXPECT_TRUE(scale.fits(1000 * largest));
        EXPECT_FALSE(scale.fits(2100 * largest));
        EXPECT_FALSE(scale.fits(-2100 * largest));
        EXPECT_FALSE(scale.fits(inf));
        EXPECT_FALSE(scale.fits(-inf));
        EXPECT_FALSE(scale.fits(std::numeric_limits<double>::quiet_NaN()));
        // 256 of the largest terms that fit do not overflow
        double term = largest;
        while (scale.fits(2 * term)) term *= 2;
        std::int64_t sum = 0;
        for (int n = 0; n < 256; ++n) ASSERT_FALSE(__builtin_add_overflow(sum, scale.from(term), &sum));
        EXPECT_EQ(scale.to(sum), 256 * term);
    }
}

TEST(FixedPoint, RepresentsToAQuantum) {
    const FixedPoint scale(1e5);
    EXPECT_LT(scale.quantum(), 1e5 * 0x1p-43);
    EXPECT_EQ(scale.to(1), scale.quantum());
    for (const double value : random_terms(1e5))
        ASSERT_LE(std::abs(scale.to(scale.from(value)) - value), scale.quantum() / 2);
    EXPECT_EQ(scale.from(-12345.678), -scale.from(12345.678));  // so that action and reaction cancel
}

}  // namespace
}  // namespace weavefront::test
