/// Decompositions: complete, balanced, repeatable.

#include "weavefront/partition/decomposition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <numeric>
#include <stdexcept>

#include "graded_target.hpp"
#include "weavefront/partition/cost.hpp"
#include "weavefront/partition/forecast.hpp"
#include "weavefront/partition/run_decomposition.hpp"

namespace weavefront::test {
namespace {

using partition::decompose;

TEST(Decomposition, IsBalancedAndCompact) {
    const auto scene = graded_target();
    const auto panel = mesh::make_panel(scene);
    const auto costs = partition::column_costs(panel, scene);
    for (const int parts : {2, 3, 4, 6, 8, 16, 24, 32, 48, 64}) {
        const auto decomposition = decompose(panel, costs, parts);
        const auto imbalance = partition::imbalance(decomposition, costs);
        // Columns under the shot cost many times what others do: a part may have half of one too much.
        const double heaviest = *std::ranges::max_element(costs),
                     all = std::accumulate(costs.begin(), costs.end(), 0.0);
        EXPECT_LT(imbalance, 1.05 + heaviest / 2 / (all / parts)) << parts;
        EXPECT_GE(imbalance, 1) << parts;
        // compact parts of n columns have about 4 sqrt(n) faces; scattered ones would have 4 n
        EXPECT_LT(static_cast<double>(partition::cut_edges(decomposition, panel)),
                  3 * std::sqrt(static_cast<double>(parts * panel.columns())))
            << parts;
        const auto again = decompose(panel, costs, parts);
        EXPECT_EQ(decomposition.owner, again.owner) << parts;
    }
}

/// METIS by itself leaves a handler that only one SIGTERM reaches. Schedulers send several.
TEST(Decomposition, LeavesTheHandlerOfTermination) {
    static volatile std::sig_atomic_t received = 0;
    struct sigaction counting {
    }, before{}, after{};
    counting.sa_handler = [](int) { received = received + 1; };
    counting.sa_flags = SA_RESTART;
    sigaction(SIGTERM, &counting, &before);
    const auto scene = graded_target();
    const auto panel = mesh::make_panel(scene);
    decompose(panel, partition::column_costs(panel, scene), 4);
    sigaction(SIGTERM, nullptr, &after);
    ASSERT_EQ(after.sa_handler, counting.sa_handler);
    ASSERT_EQ(after.sa_flags & static_cast<int>(SA_RESETHAND), 0);
    std::raise(SIGTERM);
    std::raise(SIGTERM);
    EXPECT_EQ(received, 2);
    sigaction(SIGTERM, &before, nullptr);
}

TEST(Decomposition, LeavesNoPartEmptyAndNoColumnOut) {
    mesh::Panel panel;
    panel.x = {0, 1, 2, 3, 4, 5};
    panel.y = {0, 1, 2, 3, 4, 5, 6};
    panel.plies.resize(2);
    std::vector<std::int32_t> weights(static_cast<std::size_t>(panel.columns()), 100);
    weights[14] = 5000;  // one column heavier than all others together tempts METIS to leave parts empty
    for (int parts = 1; parts <= panel.columns(); ++parts) {
        const auto decomposition = decompose(panel, weights, parts);
        std::size_t columns = 0;
        for (int part = 0; part < parts; ++part) {
            const auto own = decomposition.columns_of(part);
            ASSERT_FALSE(own.empty()) << part << " of " << parts;
            ASSERT_TRUE(std::ranges::is_sorted(own));
            for (const auto column : own)
                ASSERT_EQ(decomposition.owner[static_cast<std::size_t>(column)], part);
            columns += own.size();
        }
        ASSERT_EQ(columns, weights.size());
    }
    EXPECT_THROW(decompose(panel, weights, static_cast<int>(panel.columns()) + 1), std::invalid_argument);
}

TEST(Decomposition, BalancesWeightsWhoseSumPassesTheRangeOfMetis) {
    mesh::Panel panel;
    for (int i = 0; i <= 200; ++i) panel.x.push_back(i);
    panel.y = panel.x;
    panel.plies.resize(1);
    std::vector<std::int32_t> weights(static_cast<std::size_t>(panel.columns()), 50'000);
    for (std::size_t c = 0; c < weights.size() / 4; ++c) weights[c] = 300'000;
    EXPECT_LT(partition::imbalance(decompose(panel, weights, 16), weights), 1.05);
}

TEST(Decomposition, ImbalanceAndCutEdgesAreThoseCountedByHand) {
    mesh::Panel panel;
    panel.x = {0, 1, 2, 3};
    panel.y = {0, 1, 2};
    panel.plies.resize(1);
    // 0 0 1
    // 0 1 1
    const partition::Decomposition decomposition{2, {0, 0, 1, 0, 1, 1}};
    EXPECT_EQ(partition::cut_edges(decomposition, panel), 3);
    EXPECT_DOUBLE_EQ(partition::imbalance(decomposition, std::vector<std::int32_t>{1, 1, 1, 1, 1, 4}),
                     6 / 4.5);
}

/// The first example at 267 m/s, whose contact reaches most of the target within the run.
scene::Scene spreading_contact() {
    auto scene = graded_target();
    auto& fabric = scene.fabrics[0];
    fabric.elastic.static_modulus = 96e9;
    fabric.areal_density = 0.204;
    fabric.yarn.area = 6.48e-8;
    fabric.yarn.span = 0.909e-3;
    scene.target->symmetry = {true, true};
    scene.projectiles.front().velocity = {0, 0, 267};
    scene.time.end = 200e-6;
    return scene;
}

TEST(RunDecomposition, IsBalancedAtEveryTimeOfTheRun) {
    constexpr double reach = 2e-3;
    const auto scene = spreading_contact();
    const auto panel = mesh::make_panel(scene);
    const auto& machine = partition::committed_machine();
    for (const int parts : {2, 3, 4, 8}) {
        const auto decomposition = partition::decompose_for_run(scene, panel, parts, reach);
        const auto forecast = partition::forecast(scene, panel, decomposition, reach, machine);
        const auto of_means = partition::forecast(
            scene, panel, decompose(panel, partition::column_costs(panel, scene), parts), reach, machine);
        EXPECT_LT(forecast.element_imbalance, 1.1) << parts;
        // What balances the whole run does not balance its moments.
        EXPECT_LT(2 * (forecast.cost_imbalance - 1), of_means.cost_imbalance - 1) << parts;
        EXPECT_EQ(decomposition.owner, partition::decompose_for_run(scene, panel, parts, reach).owner)
            << parts;
    }
}

TEST(RunDecomposition, BalancesColumnsWhereNothingSpreads) {
    auto scene = spreading_contact();
    scene.projectiles.clear();
    const auto panel = mesh::make_panel(scene);
    for (const int parts : {1, 4, static_cast<int>(panel.columns())}) {
        const auto decomposition = partition::decompose_for_run(scene, panel, parts, 0);
        EXPECT_EQ(decomposition.owner, decompose(panel, partition::column_costs(panel, scene), parts).owner)
            << parts;
    }
    EXPECT_THROW(partition::decompose_for_run(scene, panel, static_cast<int>(panel.columns()) + 1, 0),
                 std::invalid_argument);
}

TEST(ColumnCosts, ContactCountsUnderTheShotOnly) {
    auto scene = graded_target();
    const auto panel = mesh::make_panel(scene);
    const auto costs = partition::column_costs(panel, scene);
    const auto middle =
        static_cast<std::size_t>(panel.columns_y() / 2 * panel.columns_x() + panel.columns_x() / 2);
    EXPECT_GT(costs[middle], 2 * costs[0]);
    scene.projectiles.clear();
    const auto still = partition::column_costs(panel, scene);
    EXPECT_EQ(*std::ranges::min_element(still), *std::ranges::max_element(still));
    EXPECT_GT(still[0], 0);
}

}  // namespace
}  // namespace weavefront::test
