#include "weavefront/study/text_table.hpp"

#include <gtest/gtest.h>

namespace weavefront::study {
namespace {

TEST(TextTable, QuotesKeepCommasAndAreDoubledInside) {
    EXPECT_EQ(cells_of(R"("a,b",,c,"say ""x""")"), (std::vector<std::string>{"a,b", "", "c", R"(say "x")"}));
    EXPECT_EQ(cells_of("1,2\r"), (std::vector<std::string>{"1", "2"}));
}

}  // namespace
}  // namespace weavefront::study
