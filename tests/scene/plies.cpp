#include <gtest/gtest.h>

#include <numbers>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

// The example with a second fabric of twice the contact thickness.
std::string two_fabrics() {
    const std::size_t begin = example.find("  kevlar129:");
    const std::size_t end = example.find("target:");
    std::string second = example.substr(begin, end - begin) + "    contact_thickness: 0.4 mm\n";
    second.replace(second.find("kevlar129"), 9, "felt");
    std::string text = example_with("    friction: 0.11", "    contact_thickness: 0.2 mm");
    return text.insert(text.find("target:"), second);
}

TEST(Plies, ListGivesEachItsFabricAngleAndDistance) {
    const Scene scene = parse(two_fabrics(), {"target.plies=[{fabric: felt}, {fabric: kevlar129, angle: 90 deg, spacing: 0.5 mm}, "
                                              "{fabric: kevlar129, gap: 0.1 mm}, {fabric: felt, gap: 0}]"});
    const std::vector<Ply>& plies = scene.target->plies;
    ASSERT_EQ(plies.size(), 4U);
    EXPECT_EQ(scene.fabrics[static_cast<std::size_t>(plies[0].fabric)].name, "felt");
    EXPECT_EQ(scene.fabrics[static_cast<std::size_t>(plies[1].fabric)].name, "kevlar129");
    EXPECT_EQ(plies[0].z, 0);
    EXPECT_EQ(plies[1].z, 0.5e-3);
    EXPECT_DOUBLE_EQ(plies[2].z, 0.8e-3);  // 0.1 mm clear of two plies of 0.2 mm
    EXPECT_DOUBLE_EQ(plies[3].z, 1.1e-3);  // touching: 0.1 mm + 0.2 mm
    EXPECT_DOUBLE_EQ(plies[1].angle, std::numbers::pi / 2);
    EXPECT_EQ(plies[2].angle, 0);
}

TEST(Plies, GapOfEqualPlies) {
    const Scene scene = parse(two_fabrics(), {"target.plies={count: 3, fabric: kevlar129, gap: 0.05 mm}"});
    EXPECT_DOUBLE_EQ(scene.target->plies[2].z, 0.5e-3);
}

TEST(Plies, PliesThatTouchAreAccepted) {
    EXPECT_TRUE(findings(two_fabrics(), {"target.plies={count: 3, fabric: felt, spacing: 0.4 mm}"}).empty());
    EXPECT_EQ(findings(two_fabrics(), {"target.plies={count: 3, fabric: felt, spacing: 0.39 mm}"}).size(), 1U);
}

TEST(Plies, OnePlyNeedsNoSpacing) { EXPECT_EQ(parse(example, {"target.plies={count: 1, fabric: kevlar129}"}).target->plies.size(), 1U); }

}  // namespace
}  // namespace weavefront::scene::test
