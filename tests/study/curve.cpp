#include "weavefront/study/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "weavefront/scene/read.hpp"

namespace weavefront::study {
namespace {

const double rounding = 1e-14;

TEST(Distance, OfLinearCurvesIsThatOfTheIntegrals) {
    const Curve up{{0, 2}, {0, 2}},
        twice{{0, 2}, {0, 4}};  // t and 2 t on [0, 2]: every norm of the difference is half that of 2 t
    EXPECT_NEAR(distance(up, twice, scene::Norm::l1), 0.5, rounding);
    EXPECT_NEAR(distance(up, twice, scene::Norm::l2), 0.5, rounding);
    EXPECT_NEAR(distance(up, twice, scene::Norm::max), 0.5, rounding);
}

TEST(Distance, TellsTheNormsApart) {
    const Curve one{{0, 1, 2}, {1, 1, 1}}, bump{{0, 1, 2}, {1, 2, 1}};  // they differ by a hat of height 1
    EXPECT_NEAR(distance(bump, one, scene::Norm::l1), 1.0 / 2, rounding);
    EXPECT_NEAR(distance(bump, one, scene::Norm::l2), std::sqrt(2.0 / 3) / std::sqrt(2.0), rounding);
    EXPECT_NEAR(distance(bump, one, scene::Norm::max), 1, rounding);
}

TEST(Distance, DoesNotDependOnWhereTheCurvesHaveTheirPoints) {
    const Curve coarse{{0, 2}, {0, 2}}, fine{{0, 0.3, 1.1, 2}, {0, 0.3, 1.1, 2}};
    EXPECT_NEAR(distance(coarse, fine, scene::Norm::l2), 0, rounding);
}

TEST(Distance, IsTakenOverTheTimeThatBothCover) {
    const Curve early{{0, 1}, {1, 1}}, longer{{0, 1, 2}, {1, 1, 100}};
    EXPECT_NEAR(distance(early, longer, scene::Norm::max), 0, rounding);
    const Curve later{{3, 4}, {1, 1}};
    EXPECT_TRUE(std::isnan(distance(early, later, scene::Norm::max)));
}

TEST(Distance, IsAbsoluteWhereTheReferenceIsZero) {
    const Curve zero{{0, 1}, {0, 0}}, one{{0, 1}, {3, 3}};
    EXPECT_NEAR(distance(one, zero, scene::Norm::max), 3, rounding);
}

class ColumnsFile : public testing::Test {
  protected:
    std::filesystem::path path = std::filesystem::temp_directory_path() / "weavefront_study_columns.csv";

    Columns read(const std::string& text) const {
        std::ofstream(path) << text;
        return read_columns(path);
    }
    ~ColumnsFile() override { std::filesystem::remove(path); }
};

TEST_F(ColumnsFile, AreReadByNameAndALineCutShortIsLeftOut) {
    const Columns columns = read("time,a\n0,1\n1,\n2,3\n3");
    ASSERT_EQ(columns.at("time").size(), 3U);
    EXPECT_EQ(columns.at("a")[2], 3);
    EXPECT_TRUE(std::isnan(columns.at("a")[1]));
}

TEST_F(ColumnsFile, NameTheLineOfWhatIsNoNumber) {
    try {
        read("time,a\n0,1\n1,x\n");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("columns.csv:3:3: a: found 'x', allowed a finite number"),
                  std::string::npos)
            << error.what();
    }
}

/// What is wrong with a table that a user has written.
std::vector<std::string> findings(const std::string& text) {
    try {
        parse_columns(text, "t.csv");
    } catch (const scene::InputError& error) {
        return error.shown();
    }
    return {};
}

using Texts = std::vector<std::string>;

TEST(MeasuredTable, EveryValueThatIsNoFiniteNumberHasItsPlace) {
    const std::string allowed = ", allowed a finite number or an empty cell";
    EXPECT_EQ(findings("time,a\n0,nan\n1,2\n-inf, inf\n1e999,0x10\n"),
              (Texts{"t.csv:2:3: a: found 'nan'" + allowed, "t.csv:4:1: time: found '-inf'" + allowed,
                     "t.csv:4:7: a: found 'inf'" + allowed, "t.csv:5:1: time: found '1e999'" + allowed,
                     "t.csv:5:7: a: found '0x10'" + allowed}));
}

TEST(MeasuredTable, ARowCutShortIsAFaultAlsoAtTheEnd) {
    EXPECT_EQ(findings("time,a\n0\n1,2\n3"),
              (Texts{"t.csv:2:1: found 1 cells, allowed 2, one a column of the header",
                     "t.csv:4:1: found 1 cells, allowed 2, one a column of the header"}));
    EXPECT_EQ(findings("time,a,time\n0,1,2\n"),
              (Texts{"t.csv:1:8: found the column 'time' again, allowed once"}));
    EXPECT_EQ(findings(""), (Texts{"t.csv:1:1: found nothing, allowed a header and rows of numbers"}));
}

TEST(MeasuredTable, BlanksOfAnyKindAroundNumbersAreNone) {
    const Columns columns = parse_columns("time, a\n# a remark\n\n 0 ,\u00a0+1.5\u2009\n", "t.csv");
    EXPECT_EQ(columns.at("a"), std::vector<double>{1.5});
}

TEST(MeasuredTable, TensOfThousandsOfFaultsAreCountedNotShown) {
    std::string text = "time,a\n";
    for (int i = 0; i < 20000; ++i) text += "x,1\n";
    const auto shown = findings(text);
    ASSERT_EQ(shown.size(), 21U);
    EXPECT_EQ(shown.back(), "and 19980 more");
}

}  // namespace
}  // namespace weavefront::study
