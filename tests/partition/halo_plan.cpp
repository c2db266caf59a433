/// Halo plans: the two sides of each pair agree, and each node has one owner.

#include "weavefront/partition/halo_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "graded_target.hpp"

namespace weavefront::test {
namespace {

using Pair = std::pair<int, int>;

struct Plans {
    std::vector<mesh::Part> parts;
    std::vector<partition::HaloPlan> plans;
};

Plans plan_all(const mesh::Panel& panel, const partition::Decomposition& decomposition) {
    Plans all;
    for (int rank = 0; rank < decomposition.parts; ++rank) {
        all.parts.push_back(mesh::make_part(panel, decomposition.columns_of(rank)));
        all.plans.push_back(partition::make_halo_plan(panel, decomposition, all.parts.back(), rank));
    }
    return all;
}

/// Global ids that each rank lists for each other.
std::map<Pair, std::vector<std::int64_t>> lists(const Plans& all) {
    std::map<Pair, std::vector<std::int64_t>> shared;
    for (std::size_t rank = 0; rank < all.plans.size(); ++rank)
        for (const auto& neighbour : all.plans[rank].neighbours)
            for (const auto node : neighbour.nodes)
                shared[{static_cast<int>(rank), neighbour.rank}].push_back(
                    all.parts[rank].node_ids[static_cast<std::size_t>(node)]);
    return shared;
}

void expect_consistent(const mesh::Panel& panel, const partition::Decomposition& decomposition) {
    const auto all = plan_all(panel, decomposition);
    const auto shared = lists(all);
    for (int a = 0; a < decomposition.parts; ++a) {
        ASSERT_TRUE(std::ranges::is_sorted(all.plans[static_cast<std::size_t>(a)].neighbours, {},
                                           &partition::Neighbour::rank));
        for (int b = 0; b < decomposition.parts; ++b) {
            if (a == b) continue;
            std::vector<std::int64_t> common;
            std::ranges::set_intersection(all.parts[static_cast<std::size_t>(a)].node_ids,
                                          all.parts[static_cast<std::size_t>(b)].node_ids,
                                          std::back_inserter(common));
            const auto listed = shared.find({a, b});
            ASSERT_EQ(listed == shared.end(), common.empty());
            if (!common.empty()) {
                ASSERT_EQ(listed->second, common);
            }
        }
    }
    std::vector<int> owners(static_cast<std::size_t>(panel.nodes()));
    for (std::size_t rank = 0; rank < all.plans.size(); ++rank)
        for (std::size_t n = 0; n < all.parts[rank].node_ids.size(); ++n)
            owners[static_cast<std::size_t>(all.parts[rank].node_ids[n])] += all.plans[rank].owned[n];
    ASSERT_EQ(std::ranges::count(owners, 1), panel.nodes());
}

TEST(HaloPlan, IsSymmetricAndEachNodeIsOwnedOnce) {
    auto scene = graded_target();
    scene.target->plies.resize(2);
    const auto panel = mesh::make_panel(scene);
    const std::vector<std::int32_t> weights(static_cast<std::size_t>(panel.columns()), 1);
    for (const int parts : {1, 2, 3, 7, 16})
        expect_consistent(panel, partition::decompose(panel, weights, parts));
}

TEST(HaloPlan, HoldsForAnyDecomposition) {
    mesh::Panel panel;
    panel.x = {0, 1, 2, 3, 4, 5, 6};
    panel.y = {0, 1, 2, 3, 4};
    panel.plies.resize(2);
    std::mt19937_64 random(3);
    for (int n = 0; n < 50; ++n) {
        partition::Decomposition decomposition{4, {}};
        for (std::int64_t c = 0; c < panel.columns(); ++c)
            decomposition.owner.push_back(static_cast<std::int32_t>(random() % 4));
        expect_consistent(panel, decomposition);
    }
}

}  // namespace
}  // namespace weavefront::test
