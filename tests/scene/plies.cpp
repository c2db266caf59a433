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
    const Scene scene = parse(
        two_fabrics(), {"target.plies=[{fabric: felt}, {fabric: kevlar129, angle: 90 deg, spacing: 0.5 mm}, "
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
    EXPECT_EQ(findings(two_fabrics(), {"target.plies={count: 3, fabric: felt, spacing: 0.39 mm}"}).size(),
              1U);
}

TEST(Plies, TouchWhereNothingIsSaid) {
    EXPECT_DOUBLE_EQ(parse(two_fabrics(), {"target.plies={count: 3, fabric: felt}"}).target->plies[2].z,
                     0.8e-3);
    const Scene scene = parse(two_fabrics(), {"target.plies=[{fabric: felt}, {fabric: kevlar129}]"});
    EXPECT_DOUBLE_EQ(scene.target->plies[1].z, 0.3e-3);
}

// A fabric of 204 g/m2 and 1440 kg/m3 is 0.1417 mm of fibre; its yarns are 0.909 mm apart.
TEST(ContactThickness, IsThatOfTheFabricWhereItsCrimpIsGeometric) {
    const auto thickness = [](const char* of_crimp) {
        return parse(example,
                     {std::string("fabrics.kevlar129.thickness=") + of_crimp, "target.plies.spacing="})
            .fabrics[0]
            .contact_thickness;
    };
    EXPECT_EQ(thickness("0.3 mm"), 0.3e-3);    // 1.4 % of crimp
    EXPECT_EQ(thickness("0.58 mm"), 0.58e-3);  // 4.97 %
    EXPECT_DOUBLE_EQ(thickness("0.59 mm"), 0.204 / 1440) << "5.1 %";
    EXPECT_DOUBLE_EQ(thickness("0.82 mm"), 0.204 / 1440);
    EXPECT_DOUBLE_EQ(thickness("0.1 mm"), 0.204 / 1440) << "no less than the fibre takes";
    EXPECT_DOUBLE_EQ(thickness("0"), 0.204 / 1440);
}

TEST(ContactSpacing, IsFineEnoughForTheProjectile) {
    const auto spacing = [](const std::vector<std::string>& overrides) {
        return parse(example, overrides).contact.spacing;
    };
    const std::string unsaid = "contact.spacing=";
    EXPECT_EQ(spacing({unsaid}), 0.25e-3);
    EXPECT_DOUBLE_EQ(*spacing({unsaid, "projectile.diameter=1.6 mm"}), 0.1e-3);
    EXPECT_DOUBLE_EQ(*spacing({unsaid, "projectile.diameter=0.016 mm", "projectile.edge_radius=0",
                               "target.mesh.edge=3 mm"}),
                     0.03e-3);
    EXPECT_EQ(spacing({"contact.spacing=0.5 mm", "projectile.diameter=1.6 mm"}), 0.5e-3);
}

TEST(Plies, OnePlyNeedsNoSpacing) {
    EXPECT_EQ(parse(example, {"target.plies={count: 1, fabric: kevlar129}"}).target->plies.size(), 1U);
}

}  // namespace
}  // namespace weavefront::scene::test
