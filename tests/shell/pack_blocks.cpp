/// Fields that few packs need.

#include "weavefront/shell/pack_blocks.hpp"

#include <gtest/gtest.h>

namespace weavefront::test {
namespace {

TEST(PackBlocks, OnlyPacksThatAreNotIdleTakeRoom) {
    shell::PackBlocks blocks(1000, 2, 1);
    const auto idle = blocks.bytes();
    blocks.set(7, 1, 3, 1);
    EXPECT_EQ(blocks.find(7), nullptr) << "the idle value needs no block";
    blocks.set(7, 1, 3, 0);
    EXPECT_EQ(blocks.get(7, 1, 3), 0);
    EXPECT_EQ(blocks.get(7, 1, 2), 1) << "the other lanes stay idle";
    EXPECT_EQ(blocks.get(7, 0, 3), 1);
    EXPECT_EQ(blocks.get(8, 1, 3), 1);
    EXPECT_EQ(blocks.bytes(), idle + 2 * 8 * sizeof(double));
    blocks.set(7, 1, 3, 1);
    EXPECT_EQ(blocks.get(7, 1, 3), 1) << "a block that there is keeps idle values too";
}

TEST(PackBlocks, WhatIsGivenBackIsTakenAgainAndIdle) {
    shell::PackBlocks blocks(10, 1, 0);
    blocks.set(2, 0, 5, 4);
    blocks.set(3, 0, 5, 9);
    const auto held = blocks.bytes();
    blocks.give_back(2);
    blocks.give_back(2);
    EXPECT_EQ(blocks.find(2), nullptr);
    EXPECT_EQ(blocks.take(6)[5], 0);
    EXPECT_EQ(blocks.get(3, 0, 5), 9);
    EXPECT_EQ(blocks.bytes(), held);
}

}  // namespace
}  // namespace weavefront::test
