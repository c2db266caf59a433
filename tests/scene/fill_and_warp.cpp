/// Fabrics whose fill and warp differ, as scenes state them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "weavefront/scene/read.hpp"

namespace weavefront::scene {
namespace {

Scene scene_of(const std::string& keys, const std::vector<std::string>& overrides = {}) {
    return parse_scene(fmt::format("fabrics: {{a: {{{}}}}}", keys), "s.yaml", overrides, Need::fabrics);
}

const std::string sheet =
    "density: 1440 kg/m^3, count: {fill: 30 1/in, warp: 36 1/in}, yarn: {denier: {fill: 600, warp: 800}}, "
    "crimp: {fill: 1 %, warp: 3 %}, elastic: {modulus: {fill: 80 GPa, warp: 90 GPa}}, "
    "failure: {strain: {fill: 3 %, warp: 4 %}}";

TEST(FillAndWarp, AYarnCrossesThoseOfTheOtherDirection) {
    const auto fabric = scene_of(sheet).fabrics.at(0);
    const auto [fill, warp] = fabric.systems();
    EXPECT_DOUBLE_EQ(fill.yarn.span, 25.4e-3 / 36);
    EXPECT_DOUBLE_EQ(fill.spacing, 25.4e-3 / 30);
    EXPECT_DOUBLE_EQ(warp.yarn.span, 25.4e-3 / 30);
    EXPECT_DOUBLE_EQ(warp.spacing, 25.4e-3 / 36);
    EXPECT_DOUBLE_EQ(fill.yarn.area, 600e-3 / 9000 / 1440);
    EXPECT_DOUBLE_EQ(warp.yarn.area, 800e-3 / 9000 / 1440);
    EXPECT_EQ(fill.elastic.static_modulus, 80e9);
    EXPECT_EQ(warp.elastic.static_modulus, 90e9);
    EXPECT_EQ(fill.strength->static_strain, 0.03);
    EXPECT_EQ(warp.strength->static_strain, 0.04);
}

TEST(FillAndWarp, MeasuredCrimpsGiveHeightsAndThickness) {
    const auto fabric = scene_of(sheet).fabrics.at(0);
    const auto [fill, warp] = fabric.systems();
    EXPECT_NEAR(fill.crimp(), 0.01, 1e-15);
    EXPECT_NEAR(warp.crimp(), 0.03, 1e-15);
    // the bar of half a span is longer by the crimp: Pythagoras
    EXPECT_NEAR(std::hypot(fill.yarn.span / 2, fill.crimp_height), 1.01 * fill.yarn.span / 2, 1e-18);
    EXPECT_EQ(fabric.thickness, 2 * (fill.crimp_height + warp.crimp_height));
}

TEST(FillAndWarp, BothWeigh) {
    const auto fabric = scene_of(sheet).fabrics.at(0);
    const double of_fill = 600e-3 / 9000 * 30 / 25.4e-3 * 1.01, of_warp = 800e-3 / 9000 * 36 / 25.4e-3 * 1.03;
    EXPECT_NEAR(fabric.areal_density, of_fill + of_warp, 1e-15);
    EXPECT_THROW((void)scene_of(sheet + ", areal_density: 240 g/m^2"), InputError);
}

TEST(FillAndWarp, AThicknessAloneIsSharedInEqualParts) {
    const auto fabric = scene_of(sheet, {"fabrics.a.crimp=", "fabrics.a.thickness=0.3 mm"}).fabrics.at(0);
    EXPECT_EQ(fabric.fill_system().crimp_height, 0.3e-3 / 4);
    EXPECT_EQ(fabric.warp_system().crimp_height, 0.3e-3 / 4);
    EXPECT_EQ(fabric.thickness, 0.3e-3);
}

TEST(FillAndWarp, EqualValuesMakeAFabricOfEqualYarns) {
    const std::string equal =
        "density: 1440 kg/m^3, count: {fill: 30 1/in, warp: 30 1/in}, yarn: {denier: {fill: 600, warp: "
        "600}}, "
        "crimp: 2 %, elastic: {modulus: {fill: 80 GPa, warp: 80 GPa}}";
    const std::string plain =
        "density: 1440 kg/m^3, count: 30 1/in, yarn: {denier: 600}, crimp: 2 %, elastic: {modulus: 80 GPa}";
    EXPECT_FALSE(scene_of(equal).fabrics.at(0).warp);
    EXPECT_EQ(scene_of(equal).resolved, scene_of(plain).resolved);
    EXPECT_NEAR(scene_of(plain).fabrics.at(0).crimp(), 0.02, 1e-15);
}

TEST(FillAndWarp, EveryDifferenceCounts) {
    const std::string plain =
        "density: 1440 kg/m^3, yarn: {span: 0.9 mm, area: 0.06 mm^2, width: 0.3 mm}, thickness: 0.3 mm, "
        "elastic: {static_modulus: 80 GPa, hooke_modulus: 160 GPa, viscosity: 1 MPa s}, areal_density: 200 "
        "g/m^2, failure: {static_strain: 3 %, hooke_strain: 3 %}";
    ASSERT_FALSE(scene_of(plain).fabrics.at(0).warp);
    for (const char* key :
         {"yarn.span={fill: 0.9 mm, warp: 0.8 mm}", "yarn.area={fill: 0.06 mm^2, warp: 0.05 mm^2}",
          "yarn.width={fill: 0.3 mm, warp: 0.2 mm}", "elastic.static_modulus={fill: 80 GPa, warp: 81 GPa}",
          "elastic.hooke_modulus={fill: 160 GPa, warp: 161 GPa}",
          "elastic.viscosity={fill: 1 MPa s, warp: 2 MPa s}",
          "failure.static_strain={fill: 3 %, warp: 3.1 %}", "failure.hooke_strain={fill: 3 %, warp: 3.1 %}"})
        EXPECT_TRUE(scene_of(plain, {std::string("fabrics.a.") + key}).fabrics.at(0).warp) << key;
}

TEST(FillAndWarp, TheResolvedSceneReadsBack) {
    const auto scene = scene_of(sheet);
    const auto again = parse_scene(scene.resolved, "s.yaml", {}, Need::fabrics);
    EXPECT_EQ(again.resolved, scene.resolved);
    const auto &one = scene.fabrics.at(0), &other = again.fabrics.at(0);
    ASSERT_TRUE(other.warp);
    EXPECT_EQ(other.thickness, one.thickness);
    EXPECT_EQ(other.warp->fill_crimp_height, one.warp->fill_crimp_height);
    EXPECT_EQ(other.warp->crimp_height, one.warp->crimp_height);
    EXPECT_EQ(other.warp->yarn.span, one.warp->yarn.span);
    EXPECT_EQ(other.warp->yarn.area, one.warp->yarn.area);
    EXPECT_EQ(other.warp->yarn.width, one.warp->yarn.width);
}

TEST(FillAndWarp, ACrimpTakesThePlaceOfTheThicknessOfTheLibrary) {
    const auto fabric = scene_of("library: kevlar_km2_s706, crimp: {fill: 1 %, warp: 2 %}").fabrics.at(0);
    EXPECT_NEAR(fabric.fill_system().crimp(), 0.01, 1e-15);
    EXPECT_NEAR(fabric.warp_system().crimp(), 0.02, 1e-15);
}

TEST(Scatter, IsReadAndReadsBack) {
    const std::string scatter = "failure.scatter={weibull_modulus: 20, gauge_length: 200 mm}";
    const auto scene = scene_of(sheet, {"fabrics.a." + scatter});
    ASSERT_TRUE(scene.fabrics.at(0).failure->scatter);
    EXPECT_EQ(scene.fabrics[0].failure->scatter->weibull_modulus, 20);
    EXPECT_EQ(scene.fabrics[0].failure->scatter->gauge_length, 0.2);
    EXPECT_EQ(scene.fabrics[0].failure->scatter->seed, 1);
    EXPECT_EQ(parse_scene(scene.resolved, "s.yaml", {}, Need::fabrics).resolved, scene.resolved);
    const auto other = scene_of(sheet, {"fabrics.a." + scatter, "fabrics.a.failure.scatter.seed=2"});
    EXPECT_NE(other.hash, scene.hash);
}

}  // namespace
}  // namespace weavefront::scene
