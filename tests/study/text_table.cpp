#include "weavefront/study/text_table.hpp"

#include <gtest/gtest.h>

namespace weavefront::study {
namespace {

std::vector<std::string> texts(std::string_view line) {
    std::vector<std::string> all;
    for (const Cell& cell : cells_of(line)) all.push_back(cell.text);
    return all;
}

TEST(TextTable, QuotesKeepCommasAndAreDoubledInside) {
    EXPECT_EQ(texts(R"("a,b",,c,"say ""x""")"), (std::vector<std::string>{"a,b", "", "c", R"(say "x")"}));
    EXPECT_EQ(texts("1,2\r"), (std::vector<std::string>{"1", "2"}));
}

TEST(TextTable, CellsKnowTheirColumnsWithoutTheBlanksAroundThem) {
    EXPECT_EQ(texts(" 1 ,\u00a02\u2009,"), (std::vector<std::string>{"1", "2", ""}));
    std::vector<std::size_t> columns;
    for (const Cell& cell : cells_of(" 1 ,\u00a02,ä,b")) columns.push_back(cell.column);
    EXPECT_EQ(columns, (std::vector<std::size_t>{2, 6, 8, 10}));
}

}  // namespace
}  // namespace weavefront::study
