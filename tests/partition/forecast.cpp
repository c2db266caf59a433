/// The cost model, against sums by hand.

#include "weavefront/partition/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graded_target.hpp"
#include "weavefront/partition/contact_zone.hpp"

namespace weavefront::test {
namespace {

partition::Machine machine() {
    return {.name = "by hand",
            .ranks = 3,
            .crowding = 1.5,
            .element = 100,
            .node = 10,
            .watch = 7,
            .touch = 1000,
            .press = 300,
            .search = 5000,
            .searches_per_step = 0.001,
            .latency = 3,
            .bandwidth = 0.5,
            .reduction = 2};
}

/// Four columns of one ply in a row.
mesh::Panel row() {
    mesh::Panel panel;
    panel.x = {0, 1, 2, 3, 4};
    panel.y = {0, 1};
    panel.plies.resize(1);
    return panel;
}

TEST(Forecast, AddsUpTheSlowestRank) {
    scene::Scene scene;
    scene.fabrics.resize(1);
    scene.target = scene::Target{};
    const auto alone = partition::forecast(scene, row(), {1, {0, 0, 0, 0}}, 0, machine());
    EXPECT_DOUBLE_EQ(alone.seconds, 4 * 100 + 10 * 10);
    EXPECT_DOUBLE_EQ(partition::efficiency(alone, alone), 1);

    // Half way to three ranks crowding is 1.25. Two nodes of 24 bytes are shared; 1.2 reductions over two
    // ranks.
    const auto two = partition::forecast(scene, row(), {2, {0, 0, 0, 1}}, 0, machine());
    EXPECT_DOUBLE_EQ(two.seconds, 1.25 * (3 * 100 + 8 * 10) + 3 + 2 * 24 / 0.5 + 1.2 * 2);
    EXPECT_DOUBLE_EQ(two.element_imbalance, 1.5);
    EXPECT_DOUBLE_EQ(two.cost_imbalance, 380.0 / ((380 + 140) / 2.0));
    EXPECT_EQ(two.cut_edges, 1);
    EXPECT_EQ(two.most_neighbours, 1);
    EXPECT_EQ(two.most_halo_bytes, 48);
    EXPECT_EQ(two.halo_bytes, 96);
    EXPECT_DOUBLE_EQ(partition::efficiency(two, alone), alone.seconds / (2 * two.seconds));

    // Four ranks crowd no more than the three that were measured.
    const auto four = partition::forecast(scene, row(), {4, {0, 1, 2, 3}}, 0, machine());
    EXPECT_DOUBLE_EQ(four.seconds, 1.5 * (100 + 4 * 10) + 2 * 3 + 2 * 2 * 24 / 0.5 + 1.2 * 2 * 2);
}

/// c^2 = E1 S/(s m) = 8 m2/s2 and V = 1 m/s, so that the zone grows at 0.48 m/s from a radius of 0.5 m, in 5
/// s to 2.9 m.
scene::Scene slow_impact() {
    scene::Scene scene;
    scene.fabrics.resize(1);
    scene.fabrics[0].elastic.static_modulus = 8;
    scene.fabrics[0].yarn.area = scene.fabrics[0].yarn.span = scene.fabrics[0].areal_density = 1;
    scene.target = scene::Target{};
    scene.target->plies.resize(2);
    scene.projectiles = {scene::Projectile{.diameter = 1, .velocity = {0, 0, 1}}};
    scene.contact.plies = scene.contact.projectile = scene::ContactLaw{};
    scene.time.end = 5;
    return scene;
}

TEST(ContactZone, GrowsWithTheTransverseWave) {
    auto scene = slow_impact();
    const partition::ContactZone zone(scene);
    EXPECT_DOUBLE_EQ(zone.radius(0), 0.5);
    EXPECT_DOUBLE_EQ(zone.radius(5), 2.9);
    EXPECT_EQ(zone.contact_time_share(0.4), 1);
    EXPECT_DOUBLE_EQ(zone.contact_time_share(1.7), 0.5);
    EXPECT_EQ(zone.contact_time_share(3), 0);
    EXPECT_DOUBLE_EQ(zone.contact_time_share(0.4, 0.5), 0.75);
    EXPECT_DOUBLE_EQ(zone.contact_time_share(1.7, 0.5), 0.5 * (1 - 0.75 * 0.5));
    EXPECT_EQ(zone.press_weight(0), 1);
    EXPECT_DOUBLE_EQ(zone.press_weight(0.5), 0.75);
    EXPECT_EQ(zone.press_weight(1.01), 0);
    scene.contact.plies.reset();
    EXPECT_DOUBLE_EQ(partition::ContactZone(scene).radius(5), 0.5);
    EXPECT_EQ(partition::ContactZone(scene).press_weight(0), 0);
    scene.contact.projectile.reset();
    EXPECT_LT(partition::ContactZone(scene).radius(5), 0);
}

TEST(Forecast, TakesTheMeanOfContactOverTheRun) {
    const auto scene = slow_impact();
    auto panel = row();
    panel.plies.resize(2);
    // Centres lie 0.71, 1.58, 2.55 and 3.54 m away: of the 16 moments the zone holds them at all but the
    // first, at 9, at 2, and at none. The first is within the diameter of 1 m: it is pressed together.
    const auto f = partition::forecast(scene, panel, {1, {0, 0, 0, 0}}, 0, machine());
    EXPECT_NEAR(f.seconds,
                2 * (4 * (100 + 7 + 0.1 / std::sqrt(8) * 5000) + 1000 * (15 + 9 + 2) / 16.0 +
                     300 * (1 - std::sqrt(0.5) / 2)) +
                    20 * 10,
                1e-9);
}

}  // namespace
}  // namespace weavefront::test
