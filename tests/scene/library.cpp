#include "weavefront/scene/library.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "weavefront/scene/read.hpp"

namespace weavefront::scene {
namespace {

Fabric fabric_of(const std::string& keys, const std::vector<std::string>& overrides = {}) {
    return parse_scene(fmt::format("fabrics: {{a: {{{}}}}}", keys), "s.yaml", overrides, Need::fabrics)
        .fabrics.at(0);
}

std::string refusal_of(const std::string& keys) {
    try {
        (void)fabric_of(keys);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

const std::string s706 =
    "density: 1440 kg/m^3, count: 34 1/in, thickness: 0.23 mm, elastic: {modulus: 82.6 GPa}, ";

// 600 denier are 600 g per 9000 m; 34 yarns an inch lie 25.4/34 mm apart.
TEST(DataSheet, GivesTheConstantsOfAYarn) {
    const auto fabric = fabric_of(s706 + "yarn: {denier: 600}, failure: {strain: 3.55 %}");
    EXPECT_DOUBLE_EQ(fabric.yarn.area, 600e-3 / 9000 / 1440);
    EXPECT_NEAR(fabric.yarn.span, 25.4e-3 / 34, 1e-17);
    const double slope = 0.23e-3 / 2 / fabric.yarn.span;
    EXPECT_NEAR(fabric.areal_density, 2 * 600e-3 / 9000 / fabric.yarn.span * std::sqrt(1 + slope * slope),
                1e-15);
    // An ellipse of the yarn's area, half as high as the fabric.
    EXPECT_NEAR(std::numbers::pi / 4 * fabric.yarn.width * 0.115e-3, fabric.yarn.area, 1e-20);
    EXPECT_EQ(fabric.elastic.static_modulus, 82.6e9);
    EXPECT_EQ(fabric.elastic.viscosity, 0);
    // Without viscosity yarns break at the smaller of both; the Hooke spring must not decide.
    EXPECT_EQ(fabric.failure->static_strain, 0.0355);
    EXPECT_GT(fabric.failure->hooke_strain * fabric.elastic.hooke_modulus / fabric.elastic.static_modulus,
              0.0355);
}

TEST(DataSheet, DtexIsGramsPerTenKilometres) {
    EXPECT_DOUBLE_EQ(fabric_of(s706 + "yarn: {dtex: 930}").yarn.area, 930e-7 / 1440);
}

TEST(DataSheet, ArealDensityIsCheckedAgainstCountAndLinearDensity) {
    EXPECT_EQ(fabric_of(s706 + "yarn: {denier: 600}, areal_density: 190 g/m^2").areal_density, 0.19);
    EXPECT_EQ(refusal_of(s706 + "yarn: {denier: 600}, areal_density: 203 g/m^2").find("s.yaml:1:"), 0U);
    EXPECT_NE(refusal_of(s706 + "yarn: {denier: 600}, areal_density: 203 g/m^2")
                  .find("fabrics.a.areal_density: found '203 g/m^2', allowed within 10 % of 180.6 g/m^2, "
                        "which count and "
                        "linear density give"),
              std::string::npos)
        << refusal_of(s706 + "yarn: {denier: 600}, areal_density: 203 g/m^2");
}

TEST(DataSheet, IsNotMixedWithWhatItGives) {
    EXPECT_NE(refusal_of(s706 + "yarn: {denier: 600, area: 0.05 mm^2}").find("fabrics.a.yarn.area: "),
              std::string::npos);
    EXPECT_NE(refusal_of(s706 + "yarn: {denier: 600, span: 0.7 mm}").find("none beside count"),
              std::string::npos);
    EXPECT_NE(refusal_of(s706 + "yarn: {denier: 600, dtex: 660}").find("none beside denier"),
              std::string::npos);
}

TEST(FabricLibrary, HoldsFabricsThatCanBeComputed) {
    for (const auto& known : fabric_library()) {
        const auto fabric = fabric_of("library: " + known.name);
        EXPECT_GT(fabric.areal_density, 0.1) << known.name;
        EXPECT_TRUE(fabric.failure) << known.name;
        EXPECT_FALSE(known.title.empty());
        for (const auto& value : known.values) EXPECT_FALSE(value.source.empty()) << known.name << value.key;
        EXPECT_NEAR(2 * fabric.yarn.area * fabric.density / fabric.yarn.span / fabric.areal_density, 1, 0.05)
            << known.name;
    }
}

// The paper's fabric has the constants of the shipped scenes.
TEST(FabricLibrary, ValuesOfTheSceneReplaceThoseOfTheLibrary) {
    const auto plain = fabric_of("library: kevlar_km2_s706");
    EXPECT_EQ(plain.thickness, 0.23e-3);
    EXPECT_EQ(fabric_of("library: kevlar_km2_s706, thickness: 0.25 mm").thickness, 0.25e-3);
    EXPECT_EQ(fabric_of("library: kevlar_km2_s706", {"fabrics.a.thickness=0.25 mm"}).thickness, 0.25e-3);
    EXPECT_EQ(fabric_of("library: kevlar_km2_s706, yarn: {width: 0.6 mm}").yarn.area, plain.yarn.area);
    EXPECT_EQ(fabric_of("library: kevlar_km2_s706, yarn: {span: 0.9 mm}").yarn.span, 0.9e-3);
    EXPECT_DOUBLE_EQ(fabric_of("library: kevlar_km2_s706, yarn: {denier: 500}").yarn.area,
                     500e-3 / 9000 / 1440);
    EXPECT_FALSE(fabric_of("library: kevlar_km2_s706", {"fabrics.a.failure="}).failure);
    EXPECT_EQ(fabric_of("library: kevlar129_it04, elastic: {modulus: 99 GPa}").elastic.viscosity, 0);
}

TEST(FabricLibrary, NamesTheNearestFabric) {
    const auto refusal = refusal_of("library: kevlar_km2_s760");
    EXPECT_NE(
        refusal.find("s.yaml:1:24: fabrics.a.library: found 'kevlar_km2_s760', allowed kevlar129_it04, "),
        std::string::npos)
        << refusal;
    EXPECT_NE(refusal.find("did you mean 'kevlar_km2_s706'?"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace weavefront::scene
