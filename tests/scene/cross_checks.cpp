#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

struct Case {
    std::vector<std::string> overrides;  ///< of the example
    std::string message;                 ///< how the only message goes on after the override
};

class CrossCheck : public testing::TestWithParam<Case> {};

TEST_P(CrossCheck, IsOneMessage) {
    const auto messages = findings(example, GetParam().overrides);
    ASSERT_EQ(messages.size(), 1U) << (messages.empty() ? "accepted" : messages[1]);
    const std::string start = "--set " + GetParam().overrides.back() + ": " + GetParam().message;
    EXPECT_TRUE(messages[0].starts_with(start)) << messages[0];
}

INSTANTIATE_TEST_SUITE_P(
    Shot, CrossCheck,
    testing::Values(
        Case{{"projectile.position=[0, 0, 0.01 mm]"},
             "projectile.position.2: found '0.01 mm', allowed at most -0.0708334 mm: the nose starts in "
             "front of the first ply"},
        Case{{"target.symmetry=[]", "projectile.position=[102 mm, 0, -1 mm]"},
             "projectile.position.0: found '102 mm', allowed from -101.6 mm to 101.6 mm: over the target"},
        Case{{"target.symmetry=[x]", "projectile.position=[0, -102 mm, -1 mm]"},
             "projectile.position.1: found '-102 mm', allowed from -101.6 mm to 101.6 mm: over the target"},
        Case{{"projectile.position=[1 mm, 0, -1 mm]"},
             "projectile.position.0: found '1 mm', allowed 0 with symmetry x"},
        Case{{"projectile.velocity=[0, 1 m/s, 400 m/s]"},
             "projectile.velocity.1: found '1 m/s', allowed 0 with symmetry y"},
        Case{{"projectile.velocity=[0, 0, -400 m/s]"},
             "projectile.velocity.2: found '-400 m/s', allowed more than 0: towards the target"},
        Case{{"projectile.velocity=[0, 400 m/s]"},
             "projectile.velocity: found a list of 2, allowed a list of 3, each a velocity"},
        Case{{"projectile.velocity=400 m/s"},
             "projectile.velocity: found '400 m/s', allowed a list of 3, each a velocity"},
        Case{{"projectile.velocity=[0, 0, 400]"},
             "projectile.velocity.2: found '400', a number without a unit, allowed a velocity"},
        Case{{"contact.spacing=1e-9 mm"},
             "contact.spacing: found '1e-9 mm', allowed at least a thousandth of the elements at the edge"},
        Case{{"projectile.mass=0 g"}, "projectile.mass: found '0 g', allowed a mass greater than 0"},
        Case{{"projectile.edge_radius=2.7 mm"},
             "projectile.edge_radius: found '2.7 mm', allowed at most half the diameter"},
        Case{{"projectile.length=0.5 mm"},
             "projectile.length: found '0.5 mm', allowed at least twice the edge radius"},
        Case{{"projectile.edge_radius=", "projectile.shape=sphere", "projectile.length=5 mm"},
             "projectile.length: found '5 mm', allowed none for a sphere"},
        Case{{"projectile.shape=cilinder"},
             "projectile.shape: found 'cilinder', allowed cylinder, sphere, did you mean 'cylinder'?"}));

INSTANTIATE_TEST_SUITE_P(
    Target, CrossCheck,
    testing::Values(
        Case{{"target.size=[203.2 mm, 0 mm]"},
             "target.size.1: found '0 mm', allowed a length greater than 0"},
        Case{{"target.size=203.2 mm"},
             "target.size: found '203.2 mm', allowed a list of 2, each a length greater than 0"},
        Case{{"target.mesh.center=4 mm"},
             "target.mesh.center: found '4 mm', allowed at most the element size at the edge"},
        Case{{"target.mesh.edge=", "target.mesh.center=110 mm"},
             "target.mesh.center: found '110 mm', allowed at most 101.6 mm, half of the target"},
        Case{{"target.mesh.center=0"}, "target.mesh.center: found '0', allowed a length greater than 0"},
        Case{{"target.mesh.growth=0.9"},
             "target.mesh.growth: found '0.9', allowed a number of at least 1, such as '1.5 or 150 %'"},
        Case{{"target.mesh={center: 1 um}"},
             "target.mesh: found a map of keys, allowed sizes that give at most 2147483647 nodes a ply, not "
             "1.03e+10"},
        Case{{"target.symmetry=[x, z]"}, "target.symmetry.1: found 'z', allowed x, y"},
        Case{{"target.symmetry=x"}, "target.symmetry: found 'x', allowed a list of x, y"},
        Case{{"target.edges.x=fxed"},
             "target.edges.x: found 'fxed', allowed fixed, sliding, frame, free, clamped, pinned, did you "
             "mean 'fixed'?"},
        Case{{"target.plies.count=0"},
             "target.plies.count: found '0', allowed a whole number from 1 to 10000"},
        Case{{"target.plies.count=2.5"},
             "target.plies.count: found '2.5', allowed a whole number from 1 to 10000"},
        Case{{"target.plies.fabric=kevlar128"},
             "target.plies.fabric: found 'kevlar128', allowed the name of a fabric of the scene, did you "
             "mean 'kevlar129'?"},
        Case{
            {"target.plies.spacing=0.1 mm"},
            "target.plies.spacing: found '0.1 mm', allowed at least 0.141667 mm, the mean contact thickness"},
        Case{{"target.plies.gap=0.1 mm"}, "target.plies.gap: found '0.1 mm', allowed either spacing or gap"},
        Case{{"target.plies.angle=45 deg"},
             "target.plies.angle: found '45 deg', allowed a multiple of 90 deg where the target has a "
             "symmetry"},
        Case{{"target.plies=[]"}, "target.plies: found an empty list, allowed at least one ply"},
        Case{{"target.plies=[{fabric: kevlar129, spacing: 1 mm}]"},
             "target.plies.0.spacing: found '1 mm', allowed none on the first ply"},
        Case{{"target.plies=[kevlar129]"},
             "target.plies.0: found 'kevlar129', allowed a map with keys fabric, angle, spacing, gap"}));

TEST(CrossChecks, AFrameHasBarsWhereEdgesRestOnIt) {
    const std::string rests = "target.edges={x: fixed, y: frame}";
    const auto framed = parse(example, {rests, "target.frame={opening: {y: 180 mm}}"});
    ASSERT_TRUE(framed.target->frame);
    EXPECT_FALSE(framed.target->frame->half_opening[0]);
    EXPECT_DOUBLE_EQ(framed.target->frame->half_opening[1].value(), 90e-3);
    EXPECT_EQ(framed.target->frame->edge_radius, 1e-3);
    EXPECT_EQ(framed.contact.frame.stiffness, 5.6e12);
    EXPECT_EQ(parse(framed.resolved, {}).hash, framed.hash);
    const auto one = [](const std::vector<std::string>& overrides) {
        const auto all = findings(example, overrides);
        return all.size() == 1 ? all[0].substr(all[0].find("target.frame: ") == std::string::npos
                                                   ? 0
                                                   : all[0].rfind("target.frame: "))
                               : "";
    };
    EXPECT_EQ(one({rests}), "target.frame: found nothing, allowed a map with keys edge_radius, opening");
    EXPECT_NE(
        one({rests, "target.frame={opening: {y: 300 mm}}"}).find("allowed less than the target's 203.2 mm"),
        std::string::npos);
    EXPECT_NE(one({rests, "target.frame={opening: {x: 3 mm, y: 180 mm}}"})
                  .find("allowed only where edges.x is frame"),
              std::string::npos);
    EXPECT_NE(one({"target.frame={opening: {y: 180 mm}}"}).find("allowed a frame where an edge rests on it"),
              std::string::npos);
    EXPECT_NE(one({"contact.frame={}"}).find("allowed only with an edge that rests on the frame"),
              std::string::npos);
}

TEST(CrossChecks, SymmetricEdgesAndNamesAreAccepted) {
    EXPECT_EQ(parse(example, {"target.edges={x: clamped, y: pinned}"}).target->edges,
              (std::array{Edge::fixed, Edge::fixed}));
    EXPECT_EQ(parse(example, {"target.edges={x: sliding, y: free}"}).target->edges,
              (std::array{Edge::sliding, Edge::free}));
    EXPECT_TRUE(findings(example, {"target.plies.angle=90 deg"}).empty());
    EXPECT_TRUE(findings(example, {"target.symmetry=[]", "target.plies.angle=45 deg"}).empty());
}

// A projectile that may start where the default puts it, and no lower.
TEST(CrossChecks, TouchingIsOutside) {
    EXPECT_TRUE(findings(example, {"projectile.position=[0, 0, -0.0708334 mm]"}).empty());
}

TEST(CrossChecks, EmptyFabricsAreRefused) {
    EXPECT_EQ(
        findings("fabrics: {}", {}, Need::fabrics),
        std::vector<std::string>{"s.yaml:1:1: fabrics: found an empty map, allowed at least one fabric"});
    EXPECT_EQ(findings("title: x", {}, Need::fabrics).size(), 1U);
}

TEST(CrossChecks, FabricNamesFitIntoPaths) {
    for (const std::string name : {"kevlar.129", "a=b", "\"\""}) {
        const auto messages = findings(example_with("  kevlar129:", "  " + name + ":"));
        ASSERT_FALSE(messages.empty()) << name;
        EXPECT_NE(messages[0].find("allowed a name without '.' and '='"), std::string::npos) << messages[0];
    }
}

}  // namespace
}  // namespace weavefront::scene::test
