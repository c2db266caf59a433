#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

TEST(Override, ReplacesValuesAtAnyDepth) {
    const Scene scene =
        parse(example, {"fabrics.kevlar129.formulation=paper", "projectile.velocity=[0,0,267 m/s]",
                        "target.mesh.center=2 mm", "title=a=b", "damping=10 1/s"});
    EXPECT_EQ(scene.fabrics[0].formulation, Formulation::paper);
    EXPECT_EQ(scene.projectile->velocity[2], 267);
    EXPECT_EQ(scene.target->mesh.center, 2e-3);
    EXPECT_EQ(scene.title, "a=b");
    EXPECT_EQ(scene.damping, 10);
}

TEST(Override, ReachesListItemsByNumber) {
    EXPECT_EQ(parse(example, {"projectile.velocity.2=267 m/s"}).projectile->velocity[2], 267);
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

TEST(Override, ThatLeadsNowhereIsNamed) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"time.safty=0.5",
         "time.safty: found an unknown key, allowed end, safety, stop, did you mean 'safety'?"},
        {"fabrics.kevlar129.failur=",
         "fabrics.kevlar129.failur: found an unknown key, allowed formulation, "},
        {"fabrics.kevlar128.thickness=1 mm",
         "fabrics.kevlar128.thickness: found 'kevlar128', allowed the name of a fabric of the scene, did you "
         "mean 'kevlar129'?"},
        {"projectile.velocity.3=1 m/s", "projectile.velocity.3: found '3', allowed an item from 0 to 2"},
        {"time.end.x=1", "time.end.x: found 'x' below '200 us', allowed keys of a map only"},
        {"time.end=5 kg", "time.end: found '5 kg', a mass, allowed a time greater than 0, such as '200 us'"},
        {"time.end=[5", "time.end: not YAML: a '[' is not closed by ']', or a ',' is missing"},
        {"tim.end=5 s",
         "tim: found an unknown key, allowed title, fabrics, target, projectile, contact, damping, time, "
         "limits, output, did you "
         "mean 'time'?"},
        {"time.end", "found no PATH=VALUE, allowed such as --set projectile.mass='2.8 g'"},
        {"=5", "found no PATH=VALUE"},
    };
    for (const auto& [text, message] : cases) {
        const auto messages = findings(example, {text});
        ASSERT_EQ(messages.size(), 1U) << text;
        EXPECT_TRUE(messages[0].starts_with("--set " + text + ": " + message)) << messages[0];
    }
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
