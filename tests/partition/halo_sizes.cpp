/// What parts hold and exchange, against counts by hand.

#include "weavefront/partition/halo_sizes.hpp"

#include <gtest/gtest.h>

namespace weavefront::test {
namespace {

/// 0 1 1
/// 0 0 1  of two plies; four of the twelve footprint nodes are shared.
mesh::Panel six_columns() {
    mesh::Panel panel;
    panel.x = {0, 1, 2, 3};
    panel.y = {0, 1, 2};
    panel.plies.resize(2);
    return panel;
}
const partition::Decomposition two_parts{2, {0, 0, 1, 0, 1, 1}};

TEST(HaloSizes, CountsSharedNodes) {
    for (const auto& part : partition::halo_sizes(six_columns(), two_parts, 0)) {
        EXPECT_EQ(part.columns, 3);
        EXPECT_EQ(part.nodes, 8 * 2);
        EXPECT_EQ(part.neighbours, 1);
        EXPECT_EQ(part.messages, 1);
        EXPECT_EQ(part.bytes_sent, 4 * 2 * 24);
        EXPECT_EQ(part.bytes_received, 4 * 2 * 24);
        EXPECT_EQ(part.ghosts, 0);
    }
}

TEST(HaloSizes, CountsGhostsWithinReachOfAnyColumn) {
    // Each part sees the four nodes that it does not hold: it is sent the forces on those, and on the shared
    // ones.
    for (const auto& part : partition::halo_sizes(six_columns(), two_parts, 0.5)) {
        EXPECT_EQ(part.ghosts, 4 * 2);
        EXPECT_EQ(part.messages, 1);
        EXPECT_EQ(part.bytes_sent, (4 + 4) * 2 * 24);
        EXPECT_EQ(part.bytes_received, part.bytes_sent);
    }
    // 0 | 1 | 2 in a row: only what lies within reach counts, and what touches it.
    mesh::Panel row = six_columns();
    row.y = {0, 1};
    const auto sizes = partition::halo_sizes(row, {3, {0, 1, 2}}, 0.5);
    EXPECT_EQ(sizes[0].ghosts, 2 * 2);
    EXPECT_EQ(sizes[1].ghosts, 4 * 2);
    EXPECT_EQ(sizes[0].neighbours, 1);
    EXPECT_EQ(sizes[0].messages, 2);
    // Part 0 sends its outer nodes to part 1, its inner ones to 1 and to 2, whose ghosts they are. It is sent
    // its inner ones by part 1, and the far ones of column 1, its ghosts, by both who hold them.
    EXPECT_EQ(sizes[0].bytes_sent, (2 + 2 * 2) * 2 * 24);
    EXPECT_EQ(sizes[0].bytes_received, (2 + 2 * 2) * 2 * 24);
    // The bounding box of part 0, an L, holds all columns; the one in its far corner is near to neither leg.
    mesh::Panel square = row;
    square.x = square.y = {0, 1, 2, 3};
    const auto bent = partition::halo_sizes(square, {2, {0, 0, 0, 0, 1, 1, 0, 1, 1}}, 0.5);
    EXPECT_EQ(bent[0].ghosts, 3 * 2);
}

TEST(HaloSizes, OnePartExchangesNothing) {
    const auto panel = six_columns();
    const auto sizes = partition::halo_sizes(panel, {1, std::vector<std::int32_t>(6, 0)}, 10);
    ASSERT_EQ(sizes.size(), 1U);
    EXPECT_EQ(sizes[0].nodes, panel.nodes());
    EXPECT_EQ(sizes[0].messages + sizes[0].bytes_sent + sizes[0].bytes_received + sizes[0].ghosts, 0);
}

}  // namespace
}  // namespace weavefront::test
