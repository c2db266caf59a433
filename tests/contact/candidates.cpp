/// The search for candidates against trying all.

#include "weavefront/contact/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using contact::Footprint;
using contact::SweptBounds;

bool near(const Footprint& a, const Footprint& b, double reach) {
    const double apart_x = std::max(a.x_low - b.x_high, b.x_low - a.x_high),
                 apart_y = std::max(a.y_low - b.y_high, b.y_low - a.y_high);
    return apart_x <= reach && apart_y <= reach;
}

/// Global ids by trying all facets, as the header says it.
std::vector<std::int64_t> by_trying_all(const contact::Surface& surface, const SweptBounds& swept,
                                        double reach, std::size_t f) {
    std::vector<std::int64_t> found;
    if (!surface.alive[f]) return found;
    const auto footprint = swept.of(surface.facets[f]);
    bool hole = true;
    for (auto ply = surface.facets[f].ply + 1; hole && ply < static_cast<std::int32_t>(surface.plies.size());
         ++ply) {
        bool rim = false;
        std::vector<std::int64_t> of_ply;
        for (std::size_t o = 0; o < surface.facets.size(); ++o) {
            if (surface.facets[o].ply != ply || !surface.alive[o] ||
                !near(footprint, swept.of(surface.facets[o]), reach))
                continue;
            of_ply.push_back(surface.facets[o].id);
            rim = rim || surface.on_free_edge[o] != 0;
        }
        hole = rim || of_ply.empty();
        std::ranges::sort(of_ply);
        found.insert(found.end(), of_ply.begin(), of_ply.end());
    }
    return found;
}

Plies random_plies(std::mt19937_64& random, double size) {
    Plies plies;
    for (int ply = 0; ply < 4; ++ply) {
        const int n = 5 + ply;
        plies.add(n, {}, [&](double u, double v) {
            // graded, so that facets are larger and smaller than the bins, and some fly far off
            const double far = random() % 60 == 0 ? 50 * size : 0;
            return Vec3(size * u * u + far + uniform(random, -0.02, 0.02) * size,
                        size * v + uniform(random, -0.02, 0.02) * size, ply);
        });
    }
    plies.erode([&](std::size_t) { return random() % 20 == 0; });
    return plies;
}

TEST(Candidates, AreAllFacetsWithinReach) {
    std::mt19937_64 random(9);
    for (int n = 0; n < 30; ++n) {
        const auto plies = random_plies(random, 1);
        for (const double reach : {0.0, 0.03, 0.3}) {
            const auto candidates = contact::find_candidates(plies.surface, SweptBounds(plies.x), reach);
            ASSERT_EQ(candidates.size(), plies.surface.facets.size());
            for (std::size_t f = 0; f < plies.surface.facets.size(); ++f) {
                std::vector<std::int64_t> found;
                for (const auto other : candidates.of(static_cast<std::int32_t>(f)))
                    found.push_back(plies.surface.facets[static_cast<std::size_t>(other)].id);
                ASSERT_EQ(found, by_trying_all(plies.surface, SweptBounds(plies.x), reach, f))
                    << n << ' ' << f;
            }
        }
    }
}

// The second ply has lost its first facet: the first looks past it from all facets near its rim and from
// where the ply has gone, wherever the lost facet flies.
TEST(Candidates, IncludeThePlyBehindAtFreeEdgesAndHoles) {
    Plies plies;
    for (int ply = 0; ply < 3; ++ply)
        plies.add(6, {}, [&](double u, double v) { return Vec3(6 * u, 6 * v, ply); });
    const auto looks_past = [&](std::size_t f) {
        const auto all = contact::find_candidates(plies.surface, SweptBounds(plies.x), 0.1);
        const auto candidates = all.of(static_cast<std::int32_t>(f));
        return plies.surface.facets[static_cast<std::size_t>(candidates.back())].ply == 2;
    };
    for (std::size_t f = 0; f < 36; ++f) ASSERT_FALSE(looks_past(f)) << f;
    plies.erode([](std::size_t f) { return f == 36; });
    for (const double flown : {0.0, 3.0, 100.0}) {
        plies.x[static_cast<std::size_t>(plies.surface.facets[36].nodes[0])] =
            Vec3(flown, flown, 1);  // it alone holds this node
        for (std::size_t f = 0; f < 36; ++f) ASSERT_EQ(looks_past(f), f % 6 <= 2 && f / 6 <= 2) << f;
    }
    for (auto node = plies.x.begin() + 49; node != plies.x.begin() + 98; ++node) node->x() += 4.3;
    for (std::size_t f = 0; f < 36; ++f) ASSERT_EQ(looks_past(f), f % 6 <= 3 || f / 6 <= 2) << f;
}

TEST(Candidates, DoNotDependOnWhichFacetsAreGhosts) {
    std::mt19937_64 random(10);
    const auto plies = random_plies(random, 1);
    std::vector<std::size_t> order(plies.surface.facets.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::shuffle(order, random);
    constexpr std::int32_t owned = 40;
    std::sort(order.begin(), order.begin() + owned), std::sort(order.begin() + owned, order.end());
    auto part = plies.surface;
    for (std::size_t i = 0; i < order.size(); ++i)
        part.facets[i] = plies.surface.facets[order[i]], part.alive[i] = plies.surface.alive[order[i]],
        part.on_free_edge[i] = plies.surface.on_free_edge[order[i]];
    part.owned = owned;
    const auto candidates = contact::find_candidates(part, SweptBounds(plies.x), 0.05);
    ASSERT_EQ(candidates.size(), static_cast<std::size_t>(owned));
    for (std::int32_t f = 0; f < part.owned; ++f) {
        std::vector<std::int64_t> found;
        for (const auto other : candidates.of(f))
            found.push_back(part.facets[static_cast<std::size_t>(other)].id);
        ASSERT_EQ(found, by_trying_all(part, SweptBounds(plies.x), 0.05, static_cast<std::size_t>(f)));
    }
}

}  // namespace
}  // namespace weavefront::test
