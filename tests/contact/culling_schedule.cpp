/// Facets that the culling schedule leaves out.

#include "weavefront/contact/culling_schedule.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

constexpr double thickness = 0.2, gap = 0.5, dt = 1e-3;
constexpr int n = 4;  // facets along an edge, each 1 x 1

/// Two flat plies. The first one moves.
struct TwoPlies : Plies {
    TwoPlies() {
        for (int ply = 0; ply < 2; ++ply)
            add(n, {.z = ply * gap, .thickness = thickness, .areal_density = 0.2}, flat(n, ply * gap));
        candidates = contact::find_candidates(surface, contact::SweptBounds(x), 1);
        schedule.emplace(surface, x);
        schedule->rebuild(surface, candidates, x);
    }

    /// Moves the two plies in one step. @return facets that the schedule lets through
    std::vector<std::int32_t> step(const Vec3& first, const Vec3& second) {
        Positions v(x.size());
        for (std::size_t k = 0; k < x.size(); ++k) {
            v[k] = (k < x.size() / 2 ? first : second) / dt;
            x[k] += dt * v[k];
        }
        const contact::ContactDistances distances(surface.plies);
        const contact::FacetQuadrature quadrature(0.5, surface, x, contact::most_points_along_edge);
        std::vector<std::int32_t> active;
        schedule->for_each_active({surface, candidates, distances, quadrature, memory, {x, v, dt}},
                                  [&](std::int32_t f, std::int32_t) {
                                      active.push_back(f);
                                      if (x[0].z() > gap - thickness)
                                          memory.keep(f, {});
                                      else
                                          memory.forget(f);
                                  });
        return active;
    }

    contact::Candidates candidates;
    contact::PointMemory memory{2 * n * n};
    std::optional<contact::CullingSchedule> schedule;
};

TEST(CullingSchedule, LetsAllFacetsOfAPlyThroughWhenItComesIntoContact) {
    TwoPlies plies;
    const double clear = gap - thickness;
    EXPECT_TRUE(plies.step({0, 0, 0}, {0, 0, 0}).empty());
    for (int k = 0; k < 9; ++k) EXPECT_TRUE(plies.step({0, 0, 0.1 * clear}, {0, 0, 0}).empty()) << k;
    EXPECT_EQ(plies.step({0, 0, 0.1 * clear}, {0, 0, 0}).size(), static_cast<std::size_t>(n * n));
}

// A clearance of fewer than ten steps is followed facet by facet.
TEST(CullingSchedule, LetsFacetsThroughThatComeIntoContactWithinFewSteps) {
    TwoPlies plies;
    const double clear = gap - thickness;
    EXPECT_TRUE(plies.step({0, 0, clear - 0.04}, {0, 0, 0}).empty());
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(plies.step({0, 0, 0.01}, {0, 0, 0}).empty()) << k;
    EXPECT_EQ(plies.step({0, 0, 0.0101}, {0, 0, 0}).size(), static_cast<std::size_t>(n * n));
}

TEST(CullingSchedule, DoesNotCountCommonMotion) {
    TwoPlies plies;
    for (int k = 0; k < 20; ++k) EXPECT_TRUE(plies.step({1, 2, 3}, {1, 2, 3}).empty()) << k;
}

TEST(CullingSchedule, CullsFacetsThatHavePartedAgain) {
    TwoPlies plies;
    EXPECT_FALSE(plies.step({0, 0, 1.01 * (gap - thickness)}, {0, 0, 0}).empty());
    EXPECT_FALSE(plies.step({0, 0, 0.4 * (thickness - gap)}, {0, 0, 0}).empty()) << "they were in contact";
    EXPECT_TRUE(plies.step({0, 0, 0}, {0, 0, 0}).empty());
}

TEST(CullingSchedule, LeavesErodedFacetsOut) {
    TwoPlies plies;
    plies.surface.alive[3] = 0;
    const auto active = plies.step({0, 0, gap - thickness}, {0, 0, 0});
    EXPECT_EQ(active.size(), static_cast<std::size_t>(n * n - 1));
    EXPECT_EQ(std::ranges::find(active, 3), active.end());
}

}  // namespace
}  // namespace weavefront::test
