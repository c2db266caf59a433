/// Reference geometry that repeats is stored once and read back as it was.

#include "weavefront/shell/repeated_quads.hpp"

#include <gtest/gtest.h>

#include <random>

namespace weavefront::test {
namespace {

std::vector<shell::Quad<double>> random_quads(std::size_t count) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> one(0, 1);
    std::vector<shell::Quad<double>> quads(count);
    for (auto& q : quads)
        q = {one(random), one(random), one(random), one(random),
             one(random), one(random), one(random), one(random)};
    return quads;
}

TEST(RepeatedQuads, ReadBackAsTheyWereFromOnePeriod) {
    for (const std::size_t repeat : {1U, 3U, 7U, 8U, 12U, 20U})
        for (const std::size_t count : {1U, 5U, 8U, 24U, 61U}) {
            const auto own = random_quads(repeat);
            std::vector<shell::Quad<double>> quads;
            for (std::size_t i = 0; i < count; ++i) quads.push_back(own[i % repeat]);
            const shell::RepeatedQuads repeated(quads);
            ASSERT_EQ(repeated.repeat_length(), static_cast<std::int32_t>(std::min(repeat, count)));
            for (std::size_t i = 0; i < count; ++i) {
                const auto at = static_cast<std::int32_t>(i) % repeated.repeat_length();
                ASSERT_EQ(repeated.of(at).Bf1, quads[i].Bf1);
                ASSERT_EQ(repeated.of(at).shape, quads[i].shape);
                const auto pack = repeated.pack_from(at);
                for (std::size_t lane = 0; lane < 8 && i + lane < count; ++lane) {
                    ASSERT_EQ(pack.Bw2.get(static_cast<int>(lane)), quads[i + lane].Bw2);
                    ASSERT_EQ(pack.area.get(static_cast<int>(lane)), quads[i + lane].area);
                }
            }
        }
}

TEST(RepeatedQuads, OneThatDiffersInTheLastBitIsKept) {
    auto quads = random_quads(4);
    quads.insert(quads.end(), quads.begin(), quads.begin() + 4);
    quads[6].e1 = std::nextafter(quads[6].e1, 2);
    const shell::RepeatedQuads repeated(quads);
    EXPECT_EQ(repeated.of(6 % repeated.repeat_length()).e1, quads[6].e1);
    EXPECT_EQ(repeated.of(2).e1, quads[2].e1);
}

}  // namespace
}  // namespace weavefront::test
