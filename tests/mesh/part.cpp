/// The part of a panel that one rank holds.

#include "weavefront/mesh/part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "small_target.hpp"

namespace weavefront::test {
namespace {

TEST(Part, PartsCoverThePanelOnceAndAgreeWithIt) {
    const auto panel = mesh::make_panel(small_target());
    std::multiset<std::int64_t> elements;
    std::set<std::int64_t> nodes;
    for (int rank = 0; rank < 5; ++rank) {
        std::vector<std::int64_t> columns;
        for (std::int64_t c = 0; c < panel.columns(); ++c)
            if (c * c % 11 % 5 == rank)
                columns.push_back(c);  // scattered, so that ids and indices have nothing in common
        const auto part = mesh::make_part(panel, columns);
        ASSERT_TRUE(std::ranges::is_sorted(part.node_ids));
        ASSERT_TRUE(std::ranges::is_sorted(part.element_ids));
        for (std::size_t e = 0; e < part.element_ids.size(); ++e) {
            const auto id = part.element_ids[e];
            const auto ply = part.element_plies[e];
            ASSERT_EQ(ply, id / panel.columns());
            ASSERT_EQ(part.local_element(id), static_cast<std::int32_t>(e));
            const auto footprint = panel.footprint(id % panel.columns());
            for (std::size_t a = 0; a < 4; ++a) {
                const auto local = static_cast<std::size_t>(part.element_nodes[e][a]);
                ASSERT_EQ(part.node_ids.at(local), ply * panel.nodes_per_ply() + footprint[a]);
                ASSERT_EQ(part.positions[local], panel.position(ply, footprint[a]));
                ASSERT_EQ(part.supports[local], panel.supports(footprint[a]));
            }
        }
        for (std::size_t n = 0; n < part.node_ids.size(); ++n)
            ASSERT_EQ(part.local_node(part.node_ids[n]), static_cast<std::int32_t>(n));
        elements.insert(part.element_ids.begin(), part.element_ids.end());
        nodes.insert(part.node_ids.begin(), part.node_ids.end());
    }
    EXPECT_EQ(static_cast<std::int64_t>(elements.size()), panel.elements());
    EXPECT_EQ(std::set(elements.begin(), elements.end()).size(), elements.size());
    EXPECT_EQ(static_cast<std::int64_t>(nodes.size()), panel.nodes());
}

TEST(Part, HoldsOnlyTheNodesThatItsElementsTouch) {
    const auto panel = mesh::make_panel(small_target());
    const std::vector<std::int64_t> columns{3};
    const auto part = mesh::make_part(panel, columns);
    EXPECT_EQ(part.node_ids.size(), 4U * 3);
    EXPECT_EQ(part.local_node(0), -1);
    EXPECT_EQ(part.local_node(panel.nodes()), -1);
    EXPECT_EQ(part.local_element(2), -1);
    EXPECT_EQ(part.local_element(panel.columns() + 3), 1);
}

}  // namespace
}  // namespace weavefront::test
