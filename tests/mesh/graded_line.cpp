/// The graded line: what was asked for, and mirror symmetry.

#include "weavefront/mesh/graded_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace weavefront::test {
namespace {

using mesh::graded_line;

/// Sizes of the elements from `fine` outwards on one side, as asked for.
double asked_size(const scene::PanelMesh& mesh, std::size_t k) {
    return std::min(mesh.center * std::pow(mesh.growth, static_cast<double>(k)), mesh.edge);
}

TEST(GradedLine, KeepsItsEndsAndItsFinePointAndNoElementIsLargerThanAskedFor) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> one(0, 1);
    for (int n = 0; n < 1000; ++n) {
        const double low = -0.1 * one(random), high = 0.1 * one(random);
        const double inside =
            low + 0.5e-3 +
            (high - low - 1e-3) * one(random);  // half an element from the ends: none gives way
        const double fine = n % 10 == 0 || high - low < 1e-3 ? low : n % 10 == 1 ? high : inside;
        const scene::PanelMesh mesh{
            .center = 1e-3, .edge = 1e-3 * (1 + 3 * one(random)), .growth = 1 + 0.2 * one(random)};
        const auto line = graded_line(low, high, fine, mesh);
        ASSERT_EQ(line.front(), low);
        ASSERT_EQ(line.back(), high);
        const auto at = std::ranges::find(line, fine);
        ASSERT_NE(at, line.end());
        const auto i_fine = static_cast<std::size_t>(at - line.begin());
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const double size = line[i + 1] - line[i];
            const double asked = asked_size(mesh, i >= i_fine ? i - i_fine : i_fine - 1 - i);
            ASSERT_LT(size, asked * (1 + 2e-6))
                << n;  // a remainder of a millionth of an element makes no element of its own
            // a side is scaled as a whole: no sliver at its end
            const double first = i >= i_fine ? line[i_fine + 1] - fine : fine - line[i_fine - 1];
            ASSERT_NEAR(size / asked, first / mesh.center, 1e-11) << n;
        }
    }
}

// A sliver would set the time step of the whole run.
TEST(GradedLine, NoElementIsThinnerThanAQuarterOfItsNeighbour) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> one(0, 1);
    for (int n = 0; n < 20000; ++n) {
        const double low = -0.1 * one(random), high = low + 0.1 * one(random) + 2e-3, length = high - low;
        const double from_end = std::pow(10, -8 * one(random)) * length /
                                2;  // as often within a nanometre as within a millimetre
        const double fine = n % 2 == 0 ? low + from_end : high - from_end;
        const scene::PanelMesh mesh{.center = 1e-3,
                                    .edge = 1e-3 * (1 + 9 * one(random)),
                                    .growth = n % 3 == 0 ? 1 + 30 * one(random) : 1.08};
        const auto line = graded_line(low, high, fine, mesh);
        ASSERT_EQ(line.front(), low);
        ASSERT_EQ(line.back(), high);
        for (std::size_t i = 2; i < line.size(); ++i) {
            const double before = line[i - 1] - line[i - 2], size = line[i] - line[i - 1];
            ASSERT_GE(std::min(before, size), 0.25 * (1 - 1e-5) * std::max(before, size))
                << n;  // a remainder of a millionth is no element
        }
    }
}

TEST(GradedLine, AFinePointAtAnEndButForRoundingIsThatEnd) {
    const scene::PanelMesh mesh{.center = 0.5e-3, .edge = 4e-3, .growth = 1.08};
    const double half = 2.362 * 0.0254 / 2;
    EXPECT_EQ(graded_line(-half, half, 1.1809 * 0.0254, mesh), graded_line(-half, half, half, mesh));
    EXPECT_EQ(graded_line(-half, half, -1.1809 * 0.0254, mesh), graded_line(-half, half, -half, mesh));
}

TEST(GradedLine, IsNotFinerThanNeeded) {
    // one element fewer a side could not fill it with elements of the sizes asked for
    const scene::PanelMesh mesh{.center = 1e-3, .edge = 3e-3, .growth = 1.08};
    const auto line = graded_line(0, 0.1016, 0, mesh);
    double reached = 0;
    for (std::size_t k = 0; k + 2 < line.size(); ++k) reached += asked_size(mesh, k);
    EXPECT_LT(reached, 0.1016);
}

TEST(GradedLine, OfEqualElementsHasAsManyAsFit) {
    // whatever the rounding of their sum
    for (const double size : {1e-3, 0.7e-3, 0.3e-3, 1.1e-3})
        for (int n = 1; n < 300; ++n)
            ASSERT_EQ(graded_line(0, n * size, 0, {.center = size, .edge = size, .growth = 1}).size(),
                      static_cast<std::size_t>(n) + 1)
                << size;
    EXPECT_EQ(graded_line(-0.1, 0.1, 0, {.center = 1e-3, .edge = 1e-3, .growth = 1}).size(), 201U);
}

TEST(GradedLine, MirrorsToTheLastBitAndHalfOfItIsTheHalfModel) {
    const scene::PanelMesh mesh{.center = 0.7e-3, .edge = 3.1e-3, .growth = 1.07};
    const auto whole = graded_line(-0.1016, 0.1016, 0, mesh), half = graded_line(0, 0.1016, 0, mesh);
    ASSERT_EQ(whole.size(), 2 * half.size() - 1);
    for (std::size_t i = 0; i < whole.size(); ++i) ASSERT_EQ(whole[i], -whole[whole.size() - 1 - i]);
    for (std::size_t i = 0; i < half.size(); ++i) ASSERT_EQ(half[i], whole[half.size() - 1 + i]);
}

}  // namespace
}  // namespace weavefront::test
