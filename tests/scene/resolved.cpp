#include <gtest/gtest.h>

#include <set>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

// Values that no short decimal gives, in every key.
const std::vector<std::string> awkward{
    "title=\"a: 'b' # \\\"c\\\"\"",
    "fabrics.kevlar129.formulation=paper",
    "fabrics.kevlar129.yarn.span=0.0357874015748031 in",
    "fabrics.kevlar129.thickness=0.0323 in",
    "fabrics.kevlar129.failure={static_strain: 3.3 %, hooke_strain: 2.7 %, erode: any_yarn}",
    "fabrics.kevlar129.lateral={modulus: 7.4 GPa, shear_modulus: 2.5 GPa, transition: 3.1 deg}",
    "fabrics.kevlar129.hourglass=0.07",
    "fabrics.kevlar129.contact_thickness=0.00567 in",
    "target.plies=[{fabric: kevlar129, angle: 30 deg}, {fabric: kevlar129, gap: 0.003 in}, {fabric: "
    "kevlar129, angle: -10 deg, gap: 0.1 "
    "mm}]",
    "target.symmetry=[]",
    "target.edges={x: sliding, y: free}",
    "target.mesh.growth=1.1",
    "projectile={shape: cylinder, diameter: 0.21 in, edge_radius: 0.01 in, mass: 44 grain, position: [1 mm, "
    "0.1 in, -0.2 in], velocity: "
    "[1 ft/s, -2 km/h, 1404 ft/s]}",
    "contact={spacing: nodes, projectile: {stiffness: 1e3 ksi/in, unloading: 3, damping: 0.1, friction: "
    "{static: 31 %, kinetic: 0.17, stiffness_ratio: 0.77}}, plies: {friction: 0.13}}",
    "damping=3 1/min",
    "time={end: 0.000003 min, safety: 0.8}",
    "limits.energy_error=7 %",
    "output={interval: 0, history: 1.3 us, fields: [crimp, velocity]}",
};

void expect_equal(const ContactLaw& a, const ContactLaw& b) {
    EXPECT_EQ(a.stiffness, b.stiffness);
    EXPECT_EQ(a.unloading, b.unloading);
    EXPECT_EQ(a.damping, b.damping);
    ASSERT_EQ(a.friction.has_value(), b.friction.has_value());
    if (!a.friction) return;
    EXPECT_EQ(a.friction->static_coefficient, b.friction->static_coefficient);
    EXPECT_EQ(a.friction->kinetic_coefficient, b.friction->kinetic_coefficient);
    EXPECT_EQ(a.friction->stiffness_ratio, b.friction->stiffness_ratio);
}

void expect_equal(const Fabric& a, const Fabric& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.formulation, b.formulation);
    EXPECT_EQ(a.areal_density, b.areal_density);
    EXPECT_EQ(a.yarn.span, b.yarn.span);
    EXPECT_EQ(a.thickness, b.thickness);
    EXPECT_EQ(a.elastic.viscosity, b.elastic.viscosity);
    EXPECT_EQ(a.failure->erode, b.failure->erode);
    EXPECT_EQ(a.failure->static_strain, b.failure->static_strain);
    EXPECT_EQ(a.lateral->locking_angle, b.lateral->locking_angle);
    EXPECT_EQ(a.lateral->transition, b.lateral->transition);
    EXPECT_EQ(a.friction, b.friction);
    EXPECT_EQ(a.transverse_shear, b.transverse_shear);
    EXPECT_EQ(a.hourglass, b.hourglass);
    EXPECT_EQ(a.contact_thickness, b.contact_thickness);
}

void expect_equal(const Target& a, const Target& b) {
    EXPECT_EQ(a.size, b.size);
    ASSERT_EQ(a.plies.size(), b.plies.size());
    for (std::size_t i = 0; i < a.plies.size(); ++i) {
        EXPECT_EQ(a.plies[i].angle, b.plies[i].angle);
        EXPECT_EQ(a.plies[i].z, b.plies[i].z);
    }
    EXPECT_EQ(a.mesh.center, b.mesh.center);
    EXPECT_EQ(a.mesh.edge, b.mesh.edge);
    EXPECT_EQ(a.mesh.growth, b.mesh.growth);
    EXPECT_EQ(a.symmetry, b.symmetry);
    EXPECT_EQ(a.edges, b.edges);
    EXPECT_EQ(a.clamps, b.clamps);
    ASSERT_EQ(a.frame.has_value(), b.frame.has_value());
    if (!a.frame) return;
    EXPECT_EQ(a.frame->half_opening, b.frame->half_opening);
    EXPECT_EQ(a.frame->radius, b.frame->radius);
    EXPECT_EQ(a.frame->edge_radius, b.frame->edge_radius);
}

void expect_equal(const Scene& a, const Scene& b) {
    EXPECT_EQ(a.title, b.title);
    ASSERT_EQ(a.fabrics.size(), b.fabrics.size());
    for (std::size_t i = 0; i < a.fabrics.size(); ++i) expect_equal(a.fabrics[i], b.fabrics[i]);
    expect_equal(*a.target, *b.target);
    EXPECT_EQ(a.projectiles.front().shape, b.projectiles.front().shape);
    EXPECT_EQ(a.projectiles.front().diameter, b.projectiles.front().diameter);
    EXPECT_EQ(a.projectiles.front().edge_radius, b.projectiles.front().edge_radius);
    EXPECT_EQ(a.projectiles.front().length, b.projectiles.front().length);
    EXPECT_EQ(a.projectiles.front().mass, b.projectiles.front().mass);
    EXPECT_EQ(a.projectiles.front().position, b.projectiles.front().position);
    EXPECT_EQ(a.projectiles.front().velocity, b.projectiles.front().velocity);
    EXPECT_EQ(a.contact.spacing, b.contact.spacing);
    expect_equal(*a.contact.projectile, *b.contact.projectile);
    expect_equal(*a.contact.plies, *b.contact.plies);
    EXPECT_EQ(a.damping, b.damping);
    EXPECT_EQ(a.time.end, b.time.end);
    EXPECT_EQ(a.time.safety, b.time.safety);
    EXPECT_EQ(a.limits.energy_error, b.limits.energy_error);
    EXPECT_EQ(a.output.interval, b.output.interval);
    EXPECT_EQ(a.output.history, b.output.history);
    EXPECT_EQ(a.output.fields, b.output.fields);
    EXPECT_EQ(a.resolved, b.resolved);
    EXPECT_EQ(a.hash, b.hash);
}

const std::vector<std::string> in_a_clamped_ring{
    "target.frame={opening: {diameter: 4.3 in}, edge_radius: 0.07 in}",
    "target.edges={x: {clamp: {pressure: 290 psi, friction: {static: 0.23, kinetic: 17 %}}}, y: {clamp: "
    "{pressure: 290 psi, friction: {static: 0.23, kinetic: 17 %}}}}"};

TEST(Resolved, ReadsBackBitForBit) {
    for (const auto& overrides : {std::vector<std::string>{}, awkward, in_a_clamped_ring}) {
        const Scene scene = parse(example, overrides);
        expect_equal(scene, parse(scene.resolved));
    }
}

TEST(Resolved, OfFabricsAloneReadsBack) {
    const std::string fabrics = example.substr(0, example.find("target:"));
    const Scene scene = parse_scene(fabrics, "s.yaml", {}, Need::fabrics);
    EXPECT_EQ(parse_scene(scene.resolved, "r.yaml", {}, Need::fabrics).resolved, scene.resolved);
}

TEST(Resolved, WithoutProjectileAndContactReadsBack) {
    const Scene scene = parse(example, {"projectile=", "contact="});
    EXPECT_TRUE(scene.projectiles.empty());
    EXPECT_EQ(parse(scene.resolved).resolved, scene.resolved);
}

TEST(Resolved, HashIsOfTheMeaningNotOfTheWording) {
    const std::string hash = parse(example).hash;
    EXPECT_EQ(hash.size(), 16U);
    EXPECT_EQ(hash, parse(example_with("0.909 mm", "909 um")).hash);
    EXPECT_EQ(hash, parse(example_with("    friction: 0.11  ", "    friction: 11 %   # 11 of 100")).hash);
    EXPECT_EQ(
        hash,
        parse(example, {"output.fields=[broken, stress, displacement]", "limits.energy_error=5 %"}).hash);
}

// Each override of the awkward scene changes the hash, so each of its keys is written out.
TEST(Resolved, HashChangesWithEveryKey) {
    std::set<std::string> hashes;
    std::vector<std::string> overrides;
    for (const std::string& override : awkward) {
        overrides.push_back(override);
        if (override.starts_with("target.plies")) overrides.emplace_back("target.symmetry=[]");
        EXPECT_TRUE(hashes.insert(parse(example, overrides).hash).second ||
                    override.starts_with("target.symmetry"))
            << override;
    }
}

}  // namespace
}  // namespace weavefront::scene::test
