/// Lists of projectiles.

#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

const std::string first =
                      "{shape: cylinder, diameter: 5.38 mm, edge_radius: 0.3 mm, mass: 2.8 g, velocity: "
                      "[0, 0, 428 m/s]}",
                  second =
                      "{standard: fsp_22, position: [20 mm, 1 in, -3 mm], velocity: [10 m/s, 0, 1500 "
                      "ft/s], spin: 9000 rpm, delay: 40 us}";

std::vector<std::string> list_of(const std::vector<std::string>& projectiles) {
    std::string list;
    for (const auto& projectile : projectiles) list += (list.empty() ? "" : ", ") + projectile;
    return {"projectile=", "target.symmetry=[]", "projectiles=[" + list + "]"};
}

TEST(Projectiles, AListOfOneIsThatProjectile) {
    EXPECT_EQ(parse(example, list_of({first})).resolved, parse(example, {"target.symmetry=[]"}).resolved);
}

TEST(Projectiles, AreReadInTheirOrder) {
    const auto scene = parse(example, list_of({first, second}));
    ASSERT_EQ(scene.projectiles.size(), 2U);
    EXPECT_EQ(scene.projectiles[0].shape, Shape::cylinder);
    EXPECT_EQ(scene.projectiles[1].shape, Shape::fsp);
    EXPECT_EQ(scene.projectiles[0].start(), scene.projectiles[0].position);
    EXPECT_DOUBLE_EQ(scene.largest_speed(), std::hypot(10, 0, 457.2));
    EXPECT_EQ(scene.least_speed(), 428);
}

TEST(Projectiles, ADelayMovesTheStartBackAlongTheVelocity) {
    const auto projectile = parse(example, list_of({second})).projectiles.front();
    EXPECT_DOUBLE_EQ(projectile.position[2], -3e-3);
    EXPECT_DOUBLE_EQ(projectile.start()[0], 20e-3 - 40e-6 * 10);
    EXPECT_DOUBLE_EQ(projectile.start()[1], 25.4e-3);
    EXPECT_DOUBLE_EQ(projectile.start()[2], -3e-3 - 40e-6 * 457.2);
}

TEST(Projectiles, AreResolvedBitForBit) {
    const auto scene = parse(example, list_of({first, second})), again = parse(scene.resolved);
    EXPECT_EQ(again.resolved, scene.resolved);
    ASSERT_EQ(again.projectiles.size(), 2U);
    EXPECT_EQ(again.projectiles[1].delay, scene.projectiles[1].delay);
    EXPECT_EQ(again.projectiles[1].angular_velocity, scene.projectiles[1].angular_velocity);
    EXPECT_NE(scene.hash, parse(example, list_of({second, first})).hash);
}

TEST(Projectiles, TheSmallestOneSetsTheSpacingOfContactPoints) {
    auto overrides = list_of({first,
                              "{shape: sphere, diameter: 1.6 mm, mass: 17 mg, position: [1 cm, 0, -1 "
                              "mm], velocity: [0, 0, 300 m/s]}"});
    overrides.emplace_back("contact.spacing=");
    EXPECT_EQ(parse(example, overrides).contact.spacing, 1.6e-3 / 16);
}

}  // namespace
}  // namespace weavefront::scene::test
