/// Search of footprints in bins, against trying all.

#include "weavefront/contact/footprint_bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using contact::Footprint;
using contact::FootprintBins;

Footprint rectangle(double x, double y, double width, double height) { return {x, x + width, y, y + height}; }

/// Small and large rectangles over a unit square; a few lie far away.
std::vector<Footprint> random_footprints(std::mt19937_64& random, int count) {
    std::vector<Footprint> footprints;
    for (int n = 0; n < count; ++n) {
        const double far = random() % 20 == 0 ? uniform(random, -50, 50) : 0,
                     size = random() % 10 == 0 ? 0.5 : 0.05;
        footprints.push_back(rectangle(uniform(random, 0, 1) + far, uniform(random, 0, 1) + far,
                                       uniform(random, 0, size), uniform(random, 0, size)));
    }
    return footprints;
}

std::vector<std::int32_t> near_by_trying_all(const std::vector<Footprint>& footprints,
                                             const std::vector<std::int32_t>& chosen, const Footprint& other,
                                             double reach) {
    std::vector<std::int32_t> found;
    for (const auto f : chosen)
        if (other.near(footprints[static_cast<std::size_t>(f)], reach)) found.push_back(f);
    std::ranges::sort(found);
    return found;
}

std::vector<std::int32_t> near_in_bins(const FootprintBins& bins, const Footprint& other, double reach) {
    std::vector<std::int32_t> found;
    bins.visit_near(other, reach, [&](std::int32_t f) {
        found.push_back(f);
        return true;
    });
    std::ranges::sort(found);
    return found;
}

TEST(FootprintBins, VisitEachNearFootprintOnce) {
    std::mt19937_64 random(12);
    for (int pass = 0; pass < 20; ++pass) {
        const auto footprints = random_footprints(random, 200);
        std::vector<std::int32_t> chosen;
        for (std::int32_t f = 0; f < 200; f += 1 + static_cast<std::int32_t>(random() % 3))
            chosen.push_back(f);
        for (const double built_for : {0.0, 0.02, 0.3}) {
            const FootprintBins bins(footprints, chosen, built_for);
            for (const double reach : {0.0, 0.02, 0.3})
                for (const auto& other : random_footprints(random, 20)) {
                    const auto expected = near_by_trying_all(footprints, chosen, other, reach);
                    ASSERT_EQ(near_in_bins(bins, other, reach), expected) << pass << ' ' << reach;
                    ASSERT_EQ(bins.any_near(other, reach), !expected.empty()) << pass << ' ' << reach;
                }
        }
    }
}

TEST(FootprintBins, FindFootprintsBeyondTheLastBin) {
    std::vector<Footprint> footprints(1000, rectangle(0, 0, 1e-3, 1e-3));  // bins of about 1 mm
    footprints.push_back(rectangle(-100, 0, 1e-3, 1e-3));
    footprints.push_back(rectangle(100, 0, 1e-3, 1e-3));
    const FootprintBins bins(footprints, 0);
    EXPECT_EQ(near_in_bins(bins, rectangle(100, 0, 1, 1), 0), (std::vector<std::int32_t>{1001}));
    EXPECT_EQ(near_in_bins(bins, rectangle(-100, 0, 1, 1), 0), (std::vector<std::int32_t>{1000}));
    EXPECT_EQ(near_in_bins(bins, rectangle(0, 0, 1, 1), 0).size(), 1000U);
    EXPECT_FALSE(bins.any_near(rectangle(50, 0, 1, 1), 0));
}

TEST(FootprintBins, OfPointsFindPoints) {
    const std::vector<Footprint> points{rectangle(0, 0, 0, 0), rectangle(0.4, 0, 0, 0),
                                        rectangle(0, 3, 0, 0)};
    const FootprintBins bins(points, 0);
    EXPECT_EQ(near_in_bins(bins, points[1], 0), (std::vector<std::int32_t>{1}));
    EXPECT_EQ(near_in_bins(bins, points[1], 0.5), (std::vector<std::int32_t>{0, 1}));
}

TEST(FootprintBins, WithoutFootprintsFindNone) {
    EXPECT_FALSE(FootprintBins({}, 1).any_near(rectangle(0, 0, 1, 1), 1e9));
    const std::vector<Footprint> one{rectangle(0, 0, 1, 1)};
    EXPECT_FALSE(FootprintBins(one, {}, 1).any_near(one[0], 1e9));
    EXPECT_FALSE(FootprintBins(one, 1).any_near(Footprint(), 1e9)) << "an empty footprint is near nothing";
}

}  // namespace
}  // namespace weavefront::test
