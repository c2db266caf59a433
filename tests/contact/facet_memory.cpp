/// What few of many facets remember.

#include "weavefront/contact/facet_memory.hpp"

#include <gtest/gtest.h>

namespace weavefront::test {
namespace {

TEST(FacetMemory, IsPerFacetAndNewAfterForget) {
    contact::FacetMemory<int> memory(10);
    EXPECT_EQ(memory.find(4), nullptr);
    memory.take(4) = 40;
    memory.take(7) = 70;
    EXPECT_EQ(*memory.find(4), 40);
    EXPECT_EQ(memory.take(7), 70);
    memory.forget(4);
    memory.forget(4);
    EXPECT_EQ(memory.find(4), nullptr);
    EXPECT_EQ(memory.take(2), 0) << "in the slot of what was forgotten";
    EXPECT_EQ(memory.take(4), 0);
    EXPECT_EQ(*memory.find(7), 70);
}

}  // namespace
}  // namespace weavefront::test
