#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

TEST(Override, ReplacesValuesAtAnyDepth) {
    const Scene scene =
        parse(example, {"fabrics.kevlar129.formulation=paper", "projectile.velocity=[0,0,267 m/s]",
                        "target.mesh.center=2 mm", "title=a=b", "damping=10 1/s"});
    EXPECT_EQ(scene.fabrics[0].formulation, Formulation::paper);
    EXPECT_EQ(scene.projectiles.front().velocity[2], 267);
    EXPECT_EQ(scene.target->mesh.center, 2e-3);
    EXPECT_EQ(scene.title, "a=b");
    EXPECT_EQ(scene.damping, 10);
}

TEST(Override, ReachesListItemsByNumber) {
    EXPECT_EQ(parse(example, {"projectile.velocity.2=267 m/s"}).projectiles.front().velocity[2], 267);
}

TEST(Override, CreatesTheMapsOnItsWay) {
    EXPECT_EQ(parse(example, {"limits.energy_error=1 %"}).limits.energy_error, 0.01);
}

TEST(Override, LastOneWins) {
    EXPECT_EQ(parse(example, {"time.safety=0.5", "time.safety=0.6"}).time.safety, 0.6);
}

TEST(Override, WithoutValueLeavesTheKeyOut) {
    EXPECT_FALSE(parse(example, {"fabrics.kevlar129.failure="}).fabrics[0].failure);
    EXPECT_FALSE(parse(example, {"contact.plies=", "limits="}).contact.plies);
    const auto messages = findings(example, {"time.safety=", "time.end="});
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_TRUE(
        messages[0].starts_with("s.yaml:25:1: time.end: found nothing, allowed a time greater than 0"))
        << messages[0];
}

TEST(Override, BringsItsOwnValueBackAfterLeavingOut) {
    EXPECT_EQ(parse(example, {"time.safety=", "time.safety=0.7"}).time.safety, 0.7);
}

TEST(Override, FindingsFollowThoseOfTheFile) {
    const auto messages =
        findings(example_with("safety: 0.9", "safety: 9"), {"title=[]", "projectile.mass=1"});
    ASSERT_EQ(messages.size(), 3U);
    EXPECT_TRUE(messages[0].starts_with("s.yaml:25:29: "));
    EXPECT_TRUE(messages[1].starts_with("--set title=[]: "));
    EXPECT_TRUE(messages[2].starts_with("--set projectile.mass=1: "));
}

}  // namespace
}  // namespace weavefront::scene::test
