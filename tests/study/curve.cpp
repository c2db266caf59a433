#include "weavefront/study/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace weavefront::study {
namespace {

const double rounding = 1e-14;

TEST(Distance, OfLinearCurvesIsThatOfTheIntegrals) {
    const Curve up{{0, 2}, {0, 2}}, twice{{0, 2}, {0, 4}};  // t and 2 t on [0, 2]: every norm of the difference is half that of 2 t
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
        EXPECT_NE(std::string(error.what()).find("columns.csv:3: found 'x'"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace weavefront::study
