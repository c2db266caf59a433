/// How much closer facets may have come.

#include "weavefront/contact/relative_motion_bound.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

constexpr double side = 10e-3, gap = 0.5e-3, dt = 1e-7;

struct TwoPlies : Plies {
    TwoPlies() {
        add(12, {}, flat(side, 0));
        add(9, {}, flat(side, gap));
        candidates = contact::find_candidates(surface, contact::SweptBounds(x), side / 4);
    }
    contact::Candidates candidates;
};

TEST(RelativeMotionBound, BoundsTheChangeOfNodeDistances) {
    TwoPlies plies;
    contact::RelativeMotionBound approach(plies.surface, plies.x);
    approach.rebuild(plies.surface, plies.candidates, plies.x);
    std::mt19937_64 random(9);
    const auto before = plies.x;
    Positions v(plies.x.size());
    for (int step = 0; step < 20; ++step) {
        for (std::size_t n = 0; n < v.size(); ++n)
            v[n] = Vec3(100, 50, 200) * plies.x[n].x() / side +
                   Vec3(uniform(random, -20, 20), uniform(random, -20, 20), uniform(random, -20, 20));
        for (std::size_t n = 0; n < v.size(); ++n) plies.x[n] += dt * v[n];
        approach.advance(v, dt);
    }
    for (std::int32_t g = 0; g < approach.groups(); ++g)
        for (const auto f : approach.facets(g))
            for (const auto other : plies.candidates.of(f))
                for (const auto a : plies.surface.facets[static_cast<std::size_t>(f)].nodes)
                    for (const auto b : plies.surface.facets[static_cast<std::size_t>(other)].nodes) {
                        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
                        ASSERT_LE(((plies.x[i] - plies.x[j]) - (before[i] - before[j])).norm(),
                                  approach.accumulated(g) * (1 + 1e-12));
                    }
}

TEST(RelativeMotionBound, DoesNotCountCommonMotion) {
    TwoPlies plies;
    contact::RelativeMotionBound approach(plies.surface, plies.x);
    approach.rebuild(plies.surface, plies.candidates, plies.x);
    approach.advance(Positions(plies.x.size(), Vec3(10, -20, 300)), dt);
    for (std::int32_t g = 0; g < approach.groups(); ++g) EXPECT_EQ(approach.accumulated(g), 0);
}

}  // namespace
}  // namespace weavefront::test
