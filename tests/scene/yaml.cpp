/// The YAML of scenes: merge keys, what is wrong with it in words of its author, and bounds on what a few
/// bytes may ask for.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

TEST(MergeKeys, GiveAMapTheEntriesThatItLacks) {
    const std::string two = R"(fabrics:
  a: &a
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}
    thickness: 0.82 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa}
  b:
    <<: *a
    thickness: 0.4 mm
  c:
    thickness: 0.3 mm
    <<: [{friction: 0.2, thickness: 1 mm}, *a]
)";
    const auto scene = parse_scene(two, "s.yaml", {}, Need::fabrics);
    EXPECT_EQ(scene.fabrics[1].areal_density, 0.204);
    EXPECT_EQ(scene.fabrics[1].thickness, 0.4e-3);
    EXPECT_EQ(scene.fabrics[2].thickness, 0.3e-3);
    EXPECT_EQ(scene.fabrics[2].friction, 0.2);
    EXPECT_EQ(scene.fabrics[2].density, 1440);
}

TEST(Bounds, AsManyPliesAsAreAllowedCanBeListed) {
    std::string plies = "plies: [{fabric: kevlar129}";
    for (int ply = 1; ply < 10'000; ++ply) plies += ", {fabric: kevlar129, angle: 90 deg, gap: 0.1 mm}";
    const std::string equal = "plies: {count: 8, fabric: kevlar129, spacing: 0.25 mm}";
    EXPECT_EQ(parse(example_with(equal, plies + "]")).target->plies.size(), 10'000U);
    const auto messages = findings(example_with(equal, plies + ", {fabric: kevlar129, gap: 0}]"));
    EXPECT_EQ(messages, std::vector<std::string>{
                            "s.yaml:16:10: target.plies: found 10001 plies, allowed at most 10000"});
}

TEST(Bounds, FindingsAreShownUpToTwentyAndCounted) {
    std::string text = example;
    for (int key = 0; key < 60'000; ++key) text += "key" + std::to_string(key) + ": 1\n";
    try {
        parse(text);
        FAIL();
    } catch (const InputError& error) {
        const auto shown = error.shown();
        ASSERT_EQ(shown.size(), 21U);
        EXPECT_EQ(shown[0].substr(0, 42), "s.yaml:27:1: key0: found an unknown key, a");
        EXPECT_EQ(shown[20], "and 59980 more");
    }
}

TEST(Bounds, FabricsAreCountedBeforeTheyAreRead) {
    std::string text = "fabrics:\n";
    for (int key = 0; key < 50'000; ++key) text += "  f" + std::to_string(key) + ": 1\n";
    EXPECT_EQ(findings(text),
              std::vector<std::string>{"s.yaml:1:1: fabrics: found 50000 fabrics, allowed at most 1000"});
}

TEST(Bounds, LongValuesAndKeysAreShortened) {
    const auto messages = findings(example_with("0.820 mm", std::string(1'000'000, 'x')) + "? " +
                                   std::string(500'000, 'k') + "\n: 1\n");
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_LT(messages[0].size(), 250U);
    EXPECT_LT(messages[1].size(), 250U);
    EXPECT_NE(messages[0].find("xxx... (1000000 bytes)"), std::string::npos) << messages[0];
}

}  // namespace
}  // namespace weavefront::scene::test
