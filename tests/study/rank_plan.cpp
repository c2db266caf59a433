#include "weavefront/study/rank_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace weavefront::study {
namespace {

TEST(RankPlan, RunsManyEqualVariantsSideBySideOnOneRankEach) {
    const std::vector<Job> jobs(12, Job{1, 100});
    const RankPlan plan = plan_ranks(jobs, 4);
    EXPECT_EQ(plan.together, 0U);
    EXPECT_EQ(plan.groups, 4);
}

TEST(RankPlan, ComputesTheLongestOneOnAllRanksWhereItWouldKeepOneBusy) {
    const std::vector<Job> jobs{{8, 100}, {64, 100}, {8, 100}};
    const RankPlan plan = plan_ranks(jobs, 2);
    EXPECT_EQ(plan.together, 1U);
    EXPECT_EQ(plan.groups, 2);
    EXPECT_EQ(plan.order, (std::vector<std::size_t>{1, 0, 2}));
    EXPECT_LT(plan.expected, 64);
}

TEST(RankPlan, GivesGroupsOfRanksToFewVariants) {
    const RankPlan plan = plan_ranks(std::vector<Job>(2, Job{1, 100}), 8);
    EXPECT_EQ(plan.together, 0U);
    EXPECT_EQ(plan.groups, 2);
}

TEST(RankPlan, DoesNotCountOnMoreRanksThanAVariantCanUse) {
    EXPECT_EQ(plan_ranks(std::vector<Job>(3, Job{5, 1}), 3).groups, 3);
    EXPECT_EQ(plan_ranks({}, 3).order.size(), 0U);
}

TEST(GroupOf, MakesGroupsOfNeighboursThatAreAlmostEqual) {
    std::vector<int> size(3, 0);
    for (int rank = 0; rank < 8; ++rank) ++size[static_cast<std::size_t>(group_of(rank, 8, 3))];
    EXPECT_EQ(*std::ranges::max_element(size) - *std::ranges::min_element(size), 1);
}

}  // namespace
}  // namespace weavefront::study
