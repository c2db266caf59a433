#include "weavefront/study/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace weavefront::study {
namespace {

/// Errors of a method of an order over sizes 1, 1/2, 1/4, ...; halving costs eight times as much.
std::vector<Point> series(double order, int points) {
    std::vector<Point> all;
    for (int i = 0; i < points; ++i)
        all.push_back({std::pow(0.5, i), std::pow(8.0, i), 0.1 * std::pow(0.5, order * i)});
    return all;
}

TEST(ObservedOrder, IsThatOfTheMethod) {
    EXPECT_NEAR(*observed_order(series(2, 4)), 2, 1e-12);
    EXPECT_NEAR(*observed_order(series(1.5, 2)), 1.5, 1e-12);
}

TEST(ObservedOrder, IsPositiveWhereMoreStepsCostMore) {
    std::vector<Point> steps;
    for (const double n : {1.0, 10.0, 100.0}) steps.push_back({n, n, 1 / (n * n)});
    EXPECT_NEAR(*observed_order(steps), 2, 1e-12);
}

TEST(ObservedOrder, LeavesOutACoarseEndThatDoesNotConvergeAndRounding) {
    std::vector<Point> all = series(2, 4);
    for (Point& point : all) point.size /= 8;
    all.insert(all.begin(), {{1, 0.01, 0.11}, {0.25, 0.1, 0.105}});
    all.push_back({1.0 / 128, 5000, 1e-15});
    all.push_back({1.0 / 256, 40000, 3e-15});
    EXPECT_NEAR(*observed_order(all), 2, 1e-12);
    EXPECT_FALSE(local_orders(all).back());
}

TEST(ObservedOrder, IsNoneWhereNothingConverges) {
    EXPECT_FALSE(observed_order(series(-1, 3)));
    EXPECT_FALSE(observed_order(series(0.1, 3)));
    // One lucky refinement among several is no order.
    EXPECT_FALSE(observed_order(std::vector<Point>{{1, 1, 0.1}, {0.5, 8, 0.001}, {0.25, 64, 0.002}}));
}

TEST(ParetoFront, HoldsWhatNothingBeats) {
    const double none = std::numeric_limits<double>::infinity();
    const std::vector<double> costs{1, 2, 3, 4, 0.5, 3}, errors{0.5, 0.6, 0.1, 0.1, none, 0.1};
    EXPECT_EQ(pareto_front(costs, errors), (std::vector<bool>{true, false, true, false, false, true}));
}

}  // namespace
}  // namespace weavefront::study
