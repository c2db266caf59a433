#include "weavefront/ballistics/mean_limit.hpp"

#include <gtest/gtest.h>

#include "weavefront/ballistics/shot.hpp"

namespace weavefront::ballistics {
namespace {

/// Partial penetrations at 400, 398, ... and complete ones at 404, 406, ... m/s.
std::vector<Shot> pairs(int each, double gap = 2) {
    std::vector<Shot> shots;
    for (int i = 0; i < each; ++i) {
        shots.push_back({400 - gap * i, false});
        shots.push_back({404 + gap * i, true});
    }
    return shots;
}

TEST(MeanLimit, TakesFiveAndFiveWhereTheyLieTogether) {
    const auto limit = mean_limit(pairs(7));
    ASSERT_TRUE(limit);
    EXPECT_NEAR(limit->v50, 402, 1e-12);
    EXPECT_NEAR(limit->spread, 20, 1e-12);
    ASSERT_EQ(limit->shots.size(), 10U);
    EXPECT_EQ(limit->shots.front(), 8U);  // the fifth partial penetration, 392 m/s
}

TEST(MeanLimit, TakesThreeAndThreeWhereFiveLieTooFarApart) {
    const auto limit = mean_limit(pairs(5, 5));  // five would span 44 m/s
    ASSERT_TRUE(limit);
    EXPECT_EQ(limit->shots.size(), 6U);
    EXPECT_NEAR(limit->spread, 24, 1e-12);
}

TEST(MeanLimit, TakesTheHighestPartialAndLowestCompleteAlsoWhereResultsAreMixed) {
    auto shots = pairs(3);
    shots.push_back({410, false});
    const auto limit = mean_limit(shots);
    ASSERT_TRUE(limit);
    EXPECT_NEAR(limit->v50, (410 + 400 + 398 + 404 + 406 + 408) / 6.0, 1e-12);
}

TEST(MeanLimit, AllowsASpreadOf125FeetASecond) {
    const double foot = 0.3048;
    std::vector<Shot> shots{{1000 * foot, false}, {1001 * foot, false}, {1002 * foot, false},
                            {1010 * foot, true},  {1011 * foot, true},  {1125 * foot, true}};
    EXPECT_TRUE(mean_limit(shots));
    shots.back().speed = 1126 * foot;
    EXPECT_FALSE(mean_limit(shots));
}

TEST(MeanLimit, NeedsThreeOfEach) { EXPECT_FALSE(mean_limit(pairs(2))); }

TEST(MixedZone, LiesBetweenLowestCompleteAndHighestPartial) {
    EXPECT_FALSE(mixed_zone(pairs(3))->exists());
    const std::vector<Shot> mixed{{100, true}, {120, false}};
    EXPECT_TRUE(mixed_zone(mixed)->exists());
    EXPECT_DOUBLE_EQ(mixed_zone(mixed)->width(), 20);
    EXPECT_FALSE(mixed_zone(std::vector<Shot>{{100, true}}));
}

}  // namespace
}  // namespace weavefront::ballistics
