#include "example.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

namespace weavefront::scene::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(Example, FabricIsReadInSi) {
    const Scene scene = parse(example);
    EXPECT_EQ(scene.title, "Eight plies of Kevlar 129 at 428 m/s");
    ASSERT_EQ(scene.fabrics.size(), 1U);
    const Fabric& fabric = scene.fabrics[0];
    EXPECT_EQ(fabric.name, "kevlar129");
    EXPECT_EQ(fabric.formulation, Formulation::consistent);
    EXPECT_EQ(fabric.areal_density, 0.204);
    EXPECT_EQ(fabric.density, 1440);
    EXPECT_EQ(fabric.yarn.span, 0.909e-3);
    EXPECT_EQ(fabric.yarn.area, 6.48e-8);
    EXPECT_EQ(fabric.yarn.width, 0.32e-3);
    EXPECT_EQ(fabric.thickness, 0.82e-3);
    EXPECT_EQ(fabric.elastic.static_modulus, 96e9);
    EXPECT_EQ(fabric.elastic.hooke_modulus, 192e9);
    EXPECT_EQ(fabric.elastic.viscosity, 35e6);
    ASSERT_TRUE(fabric.failure);
    EXPECT_EQ(fabric.failure->static_strain, 0.033);
    EXPECT_EQ(fabric.failure->hooke_strain, 0.027);
    ASSERT_TRUE(fabric.lateral);
    EXPECT_EQ(fabric.lateral->modulus, 7.4e9);
    EXPECT_EQ(fabric.lateral->shear_modulus, 2.5e9);
    EXPECT_DOUBLE_EQ(fabric.lateral->locking_angle, 35 * degree);
    EXPECT_DOUBLE_EQ(fabric.lateral->transition, 3 * degree);
    EXPECT_EQ(fabric.friction, 0.11);
    EXPECT_EQ(fabric.transverse_shear, 2.5e9);
}

TEST(Example, ImpactIsReadInSi) {
    const Scene scene = parse(example);
    ASSERT_TRUE(scene.target);
    EXPECT_EQ(scene.target->size, (std::array{0.2032, 0.2032}));
    ASSERT_EQ(scene.target->plies.size(), 8U);
    EXPECT_EQ(scene.target->plies[0].z, 0);
    EXPECT_DOUBLE_EQ(scene.target->plies[7].z, 7 * 0.25e-3);
    EXPECT_EQ(scene.target->mesh.center, 1e-3);
    EXPECT_EQ(scene.target->mesh.edge, 3e-3);
    EXPECT_EQ(scene.target->mesh.growth, 1.08);
    EXPECT_EQ(scene.target->symmetry, (std::array{true, true}));
    EXPECT_EQ(scene.target->edges, (std::array{Edge::fixed, Edge::fixed}));
    ASSERT_EQ(scene.projectiles.size(), 1U);
    EXPECT_EQ(scene.projectiles.front().shape, Shape::cylinder);
    EXPECT_EQ(scene.projectiles.front().diameter, 5.38e-3);
    EXPECT_EQ(scene.projectiles.front().edge_radius, 0.3e-3);
    EXPECT_EQ(scene.projectiles.front().mass, 2.8e-3);
    EXPECT_EQ(scene.projectiles.front().velocity, (std::array{0.0, 0.0, 428.0}));
    ASSERT_TRUE(scene.contact.projectile && scene.contact.plies);
    EXPECT_EQ(scene.contact.spacing, 0.25e-3);
    EXPECT_EQ(scene.contact.projectile->stiffness, 5.6e12);
    EXPECT_EQ(scene.contact.plies->damping, 0.2);
    EXPECT_EQ(scene.time.end, 200e-6);
    EXPECT_EQ(scene.output.interval, 5e-6);
    EXPECT_EQ(scene.output.history, 0.5e-6);
    EXPECT_EQ(scene.output.fields, (std::vector{Field::displacement, Field::stress, Field::broken}));
}

// What the reference promises for keys that are left out.
TEST(Example, DefaultsAreThoseOfTheReference) {
    const Scene scene = parse(R"(
fabrics:
  a:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 1 mm, area: 0.06 mm^2, width: 0.5 mm}
    thickness: 0
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa}
    lateral: {modulus: 7.4 GPa, shear_modulus: 2.5 GPa, transition: 3 deg}
target: {size: [10 mm, 10 mm], plies: {count: 1, fabric: a}, mesh: {center: 1 mm}}
projectile: {shape: cylinder, diameter: 5 mm, mass: 2.8 g, velocity: [0, 0, 100 m/s]}
contact: {projectile: {}, plies: {}}
time: {end: 1 ms}
output: {interval: 0, history: 1 us}
)");
    const Fabric& fabric = scene.fabrics[0];
    EXPECT_EQ(fabric.formulation, Formulation::consistent);
    EXPECT_EQ(fabric.elastic.viscosity, 0);
    EXPECT_FALSE(fabric.failure);
    EXPECT_EQ(fabric.friction, 0);
    EXPECT_EQ(fabric.transverse_shear, 0);
    EXPECT_EQ(fabric.hourglass, 0.05);
    EXPECT_DOUBLE_EQ(fabric.contact_thickness, 0.204 / 1440);
    EXPECT_DOUBLE_EQ(fabric.lateral->locking_angle, 30 * degree);  // sin(2 theta_min) = 1/2
    EXPECT_EQ(scene.target->mesh.edge, 1e-3);
    EXPECT_EQ(scene.target->mesh.growth, 1.08);
    EXPECT_EQ(scene.target->symmetry, (std::array{false, false}));
    EXPECT_EQ(scene.target->edges, (std::array{Edge::fixed, Edge::fixed}));
    EXPECT_EQ(scene.projectiles.front().edge_radius, 0);
    EXPECT_DOUBLE_EQ(scene.projectiles.front().length, 2.8e-3 / (7850 * std::numbers::pi / 4 * 25e-6));
    EXPECT_EQ(scene.projectiles.front().position, (std::array{0.0, 0.0, -fabric.contact_thickness / 2}));
    EXPECT_EQ(scene.contact.spacing, 0.25e-3);
    EXPECT_EQ(scene.contact.projectile->stiffness, 5.6e12);
    EXPECT_EQ(scene.contact.projectile->unloading, 10);
    EXPECT_EQ(scene.contact.projectile->damping, 0);
    EXPECT_EQ(scene.contact.plies->stiffness, 1.1e13);
    EXPECT_EQ(scene.contact.plies->unloading, 10);
    EXPECT_EQ(scene.contact.plies->damping, 0.2);
    EXPECT_EQ(scene.damping, 0);
    EXPECT_EQ(scene.time.safety, 0.9);
    EXPECT_EQ(scene.limits.energy_error, 0.05);
    EXPECT_EQ(scene.output.fields, (std::vector{Field::displacement, Field::stress, Field::broken}));
}

TEST(Example, ContactAtNodesHasNoSpacing) {
    EXPECT_FALSE(parse(example_with("spacing: 0.25 mm    ", "spacing: nodes  ")).contact.spacing);
}

TEST(Example, FabricsAloneServeCellAndYarn) {
    const std::string fabrics = example.substr(0, example.find("target:"));
    const Scene scene = parse_scene(fabrics, "s.yaml", {}, Need::fabrics);
    EXPECT_EQ(scene.fabrics.size(), 1U);
    EXPECT_FALSE(scene.target);
    EXPECT_EQ(findings(fabrics).size(), 3U);  // target, time, output
}

TEST(Example, FileIsReadAndNamedInMessages) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "weavefront_scene_test.yaml";
    std::ofstream(path) << example_with("mass: 2.8 g", "mass: -1 g");
    try {
        read_scene(path);
        ADD_FAILURE() << "a negative mass was accepted";
    } catch (const InputError& error) {
        EXPECT_TRUE(
            error.messages().at(0).starts_with(path.string() + ":20:77: projectile.mass: found '-1 g'"))
            << error.what();
    }
    std::filesystem::remove(path);
    try {
        read_scene(path);
        ADD_FAILURE() << "a missing file was read";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), path.string() + ": cannot be read: No such file or directory");
    }
}

}  // namespace
}  // namespace weavefront::scene::test
