/// Targets of the rays of a facet.

#include "weavefront/contact/ray_targets.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/ray_search.hpp"

namespace weavefront::test {
namespace {

using contact::RayTargets;

constexpr double thickness = 0.2, gap = 0.5;
constexpr int n = 4;  // facets along an edge, each 1 x 1

contact::PlyProperties ply_at(double z) { return {.z = z, .thickness = thickness, .areal_density = 0.2}; }

/// Three flat plies, a gap apart. The rays of the facet at hand go up, 2 x 2 of them.
struct ThreePlies : Plies {
    ThreePlies() {
        for (int ply = 0; ply < 3; ++ply) add(n, ply_at(ply * gap), flat(n, ply * gap));
    }

    /// Lists the candidates of facet 5, all facets of later plies if none are given.
    [[nodiscard]] std::vector<std::int32_t> targets(std::vector<std::int32_t> candidates = {}) const {
        RayTargets list;
        start(list);
        add_targets(list, candidates.empty() ? later_plies() : candidates);
        return facets_of(list);
    }
    void start(RayTargets& list) const { list.start(facet(), contact::corners_of(facet().nodes, x)); }
    void add_targets(RayTargets& list, const std::vector<std::int32_t>& candidates) const {
        auto rays = contact::NormalRays(rule, contact::corners_of(facet().nodes, x), up,
                                        distances().max_penetration(), distances().most());
        contact::FacetLists lists;
        for (const auto candidate : candidates) lists.add(candidate);
        lists.end_list();
        list.add(lists.of(0), rays, surface, distances(), x);
    }
    [[nodiscard]] static std::vector<std::int32_t> facets_of(const RayTargets& list) {
        std::vector<std::int32_t> facets;
        for (std::size_t k = 0; k < list.size(); ++k) facets.push_back(list[k]);
        return facets;
    }
    [[nodiscard]] static std::vector<std::int32_t> later_plies() {
        std::vector<std::int32_t> facets;
        for (std::int32_t f = n * n; f < 3 * n * n; ++f) facets.push_back(f);
        return facets;
    }
    [[nodiscard]] contact::ContactDistances distances() const {
        return contact::ContactDistances(surface.plies);
    }
    [[nodiscard]] const contact::Facet& facet() const { return surface.facets[at_hand]; }
    /// Moves a ply. @param ply 0 = struck first
    void shift(std::size_t ply, const Vec3& by) {
        constexpr std::size_t nodes = (n + 1) * (n + 1);
        for (std::size_t k = ply * nodes; k < (ply + 1) * nodes; ++k) x[k] += by;
    }

    static constexpr std::size_t at_hand = 5;
    const contact::QuadratureRule rule = contact::quadrature(2, 2);
    const std::array<Vec3, 4> up{Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)};
};

// Ply 1 is within contact distance, and shifted by less than half of a facet: the rays at a quarter of the
// facet's edges cross four facets of it.
TEST(RayTargets, AreTheFacetsWithinReachNearestCentreFirst) {
    ThreePlies plies;
    plies.shift(1, {0.3, 0.4, -0.4});
    EXPECT_EQ(plies.targets(), (std::vector<std::int32_t>{n * n + 5, n * n + 1, n * n + 4, n * n}));
}

TEST(RayTargets, AreListedPlyByPly) {
    ThreePlies plies;
    plies.shift(1, {0.3, 0.4, -0.4});
    plies.shift(2, {0, 0, -0.9});  // its facet 5 is nearer than all of ply 1
    plies.surface.on_free_edge.assign(plies.surface.facets.size(), 1);
    const auto targets = plies.targets();
    ASSERT_EQ(targets.size(), 5U);
    EXPECT_EQ(targets.front(), n * n + 5);
    EXPECT_EQ(targets.back(), 2 * n * n + 5);
}

TEST(RayTargets, LeaveOutFacetsAheadOfTheContactDistance) {
    ThreePlies plies;
    const double contact_distance = plies.distances().between(0, 1);
    plies.shift(1, {0, 0, contact_distance - gap + 1e-9});
    EXPECT_TRUE(plies.targets().empty());
    plies.shift(1, {0, 0, -2e-9});
    EXPECT_EQ(plies.targets(), (std::vector<std::int32_t>{n * n + 5}));
}

TEST(RayTargets, LeaveOutErodedFacets) {
    ThreePlies plies;
    plies.shift(1, {0, 0, -0.4});
    plies.surface.alive[n * n + 5] = 0;
    EXPECT_TRUE(plies.targets().empty());
}

TEST(RayTargets, APlyHidesThePlyBehindItUnlessItHasAFreeEdgeThere) {
    ThreePlies plies;
    plies.shift(1, {0, 0, -0.4});
    plies.shift(2, {0, 0, -0.85});
    plies.surface.on_free_edge.assign(plies.surface.facets.size(), 0);
    EXPECT_EQ(plies.targets(), (std::vector<std::int32_t>{n * n + 5}));
    plies.surface.on_free_edge[n * n + 15] = 1;  // far from the facet at hand
    EXPECT_EQ(plies.targets(), (std::vector<std::int32_t>{n * n + 5}));
    plies.surface.on_free_edge[n * n + 5] = 1;
    EXPECT_EQ(plies.targets(), (std::vector<std::int32_t>{n * n + 5, 2 * n * n + 5}));
}

TEST(RayTargets, ATargetListedEarlierStaysTheFirstAndIsListedOnce) {
    ThreePlies plies;
    plies.shift(1, {0.3, 0.4, -0.4});
    RayTargets list;
    plies.start(list);
    plies.add_targets(list, {n * n + 4});  // not the nearest
    plies.add_targets(list, ThreePlies::later_plies());
    EXPECT_EQ(ThreePlies::facets_of(list),
              (std::vector<std::int32_t>{n * n + 4, n * n + 5, n * n + 1, n * n}));
    plies.start(list);
    EXPECT_EQ(list.size(), 0U) << "another facet starts with an empty list";
}

TEST(RaySearch, ListsTheOtherCandidatesOnlyAfterTheNearestOne) {
    ThreePlies plies;
    plies.shift(1, {0.3, 0.4, -0.4});
    const auto distances = plies.distances();
    contact::FacetLists lists;
    for (const auto candidate : ThreePlies::later_plies()) lists.add(candidate);
    lists.end_list();
    const auto corners = contact::corners_of(plies.facet().nodes, plies.x);
    for (const std::int32_t nearest : {n * n + 5, -1}) {
        RayTargets list;
        contact::RaySearch search(list, {plies.facet(), plies.rule, corners, plies.up}, lists.of(0), nearest,
                                  plies.surface, distances, plies.x);
        EXPECT_EQ(list.size(), nearest < 0 ? 4U : 1U);
        std::vector<std::int32_t> tried;
        for (std::size_t k = 0; const auto target = search.target(k); ++k) tried.push_back(*target);
        EXPECT_EQ(tried, (std::vector<std::int32_t>{n * n + 5, n * n + 1, n * n + 4, n * n}));
    }
}

}  // namespace
}  // namespace weavefront::test
