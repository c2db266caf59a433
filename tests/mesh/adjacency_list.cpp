/// Lists in compressed rows.

#include "weavefront/mesh/adjacency_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace weavefront::test {
namespace {

using mesh::AdjacencyList;
using Rows = std::vector<std::vector<int>>;

template <class Offset>
Rows rows_of(const AdjacencyList<int, Offset>& list) {
    Rows rows;
    for (std::size_t r = 0; r < list.rows(); ++r) rows.emplace_back(list[r].begin(), list[r].end());
    return rows;
}

AdjacencyList<int> built(const Rows& rows) {
    AdjacencyList<int> list;
    for (const auto& row : rows) {
        for (const int item : row) list.push_back(item);
        list.end_row();
    }
    return list;
}

const Rows four_rows{{3, 1}, {}, {4, 1, 5}, {9}};

TEST(AdjacencyList, HasNoRowsAtFirst) {
    EXPECT_EQ(AdjacencyList<int>().rows(), 0U);
    EXPECT_TRUE(AdjacencyList<int>().items().empty());
}

TEST(AdjacencyList, ReturnsTheRowsThatWereBuilt) {
    const auto list = built(four_rows);
    EXPECT_EQ(rows_of(list), four_rows);
    EXPECT_TRUE(std::ranges::equal(list.offsets(), std::vector{0, 2, 2, 5, 6}));
    EXPECT_TRUE(std::ranges::equal(list.items(), std::vector{3, 1, 4, 1, 5, 9}));
}

TEST(AdjacencyList, OpenRowHoldsItemsSinceTheLastRowEnded) {
    auto list = built(four_rows);
    EXPECT_TRUE(list.open_row().empty());
    list.push_back(2);
    list.push_back(6);
    ASSERT_EQ(list.open_row().size(), 2U);
    ++list.open_row().back();
    EXPECT_EQ(list.rows(), 4U);
    list.end_row();
    EXPECT_EQ(rows_of(list).back(), (std::vector{2, 7}));
}

TEST(AdjacencyList, SortsEntriesIntoRowsAndKeepsTheirOrder) {
    const std::vector<std::pair<int, int>> entries{{2, 4}, {0, 3}, {3, 9}, {2, 1}, {0, 1}, {2, 5}};
    const AdjacencyList<int, std::size_t> list(4, [&](const auto& use) {
        for (const auto& [row, item] : entries) use(row, item);
    });
    EXPECT_EQ(rows_of(list), four_rows);
}

TEST(AdjacencyList, TruncateDropsLaterRowsAndTheOpenOne) {
    auto list = built(four_rows);
    list.push_back(8);
    list.truncate(2);
    EXPECT_EQ(rows_of(list), (Rows{{3, 1}, {}}));
    list.push_back(7);
    list.end_row();
    EXPECT_EQ(rows_of(list), (Rows{{3, 1}, {}, {7}}));
}

TEST(AdjacencyList, ItemsOfARowCanBeChanged) {
    auto list = built(four_rows);
    std::ranges::sort(list[2]);
    EXPECT_EQ(rows_of(list), (Rows{{3, 1}, {}, {1, 4, 5}, {9}}));
}

}  // namespace
}  // namespace weavefront::test
