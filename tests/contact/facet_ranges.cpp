/// Lists of facets as runs.

#include "weavefront/contact/facet_ranges.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace weavefront::test {
namespace {

std::vector<std::int32_t> all_of(const contact::FacetRanges& runs) {
    std::vector<std::int32_t> facets;
    for (const auto facet : runs) facets.push_back(facet);
    return facets;
}

TEST(FacetLists, ReturnFacetsInTheOrderAdded) {
    std::vector<std::int32_t> many(1000);
    std::iota(many.begin(), many.end(), 7);
    // The second list goes on where the first ends; the last are longer than a run can be, out of order, and
    // twice the same.
    const std::vector<std::vector<std::int32_t>> lists{{3, 4, 5, 9, 10}, {11, 12}, {}, many, {5, 4, 3, 3}};
    contact::FacetLists kept;
    for (const auto& list : lists) {
        for (const auto facet : list) kept.add(facet);
        kept.end_list();
    }
    ASSERT_EQ(kept.size(), lists.size());
    for (std::size_t n = 0; n < lists.size(); ++n) {
        const auto runs = kept.of(static_cast<std::int32_t>(n));
        EXPECT_EQ(all_of(runs), lists[n]) << n;
        EXPECT_EQ(runs.empty(), lists[n].empty());
        if (!runs.empty()) {
            EXPECT_EQ(runs.back(), lists[n].back());
        }
    }
}

}  // namespace
}  // namespace weavefront::test
