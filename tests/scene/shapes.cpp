/// Shapes of projectiles: resolved scenes, files of surfaces and the library.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <map>

#include "example.hpp"
#include "weavefront/scene/library.hpp"

namespace weavefront::scene::test {
namespace {

using Files = std::map<std::string, std::string>;

Projectile projectile_of(const std::string& keys, const Files& files = {},
                         const std::vector<std::string>& overrides = {}) {
    const ReadFile read = [&](const std::filesystem::path& path, std::size_t /*most*/) {
        return files.at(path.string());
    };
    const auto text =
        example_with("shape: cylinder, diameter: 5.38 mm, edge_radius: 0.3 mm, mass: 2.8 g", keys);
    const auto scene = parse_scene(text, "s.yaml", overrides, Need::impact, read);
    // The resolved scene needs no file and says the same.
    const auto again = parse_scene(scene.resolved, "resolved.yaml");
    EXPECT_EQ(again.resolved, scene.resolved);
    EXPECT_EQ(again.projectiles.front().diameter, scene.projectiles.front().diameter);
    EXPECT_EQ(again.projectiles.front().length, scene.projectiles.front().length);
    EXPECT_EQ(again.projectiles.front().profile, scene.projectiles.front().profile);
    EXPECT_EQ(again.projectiles.front().triangles.points, scene.projectiles.front().triangles.points);
    EXPECT_EQ(again.projectiles.front().triangles.corners, scene.projectiles.front().triangles.corners);
    return scene.projectiles.front();
}

std::string refusal_of(const std::string& keys, const Files& files = {}) {
    try {
        (void)projectile_of(keys, files);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(Shapes, AreResolvedBitForBit) {
    for (const auto* keys :
         {"shape: hemisphere, diameter: 0.21 in, length: 9.7 mm",
          "shape: cone, diameter: 0.21 in, length: 9.7 mm, "
          "apex_angle: 37 deg, tip_radius: 0.3 mm",
          "shape: truncated_cone, diameter: 0.21 in, length: 9.7 mm, "
          "apex_angle: 61 deg, tip_diameter: 0.13 in",
          "shape: ogive, diameter: 0.21 in, length: 19.7 mm, "
          "caliber_radius_head: 2.7, tip_radius: 0.7 mm",
          "shape: fsp, diameter: 0.21 in, length: 9.7 mm, "
          "flat_width: 0.1 in",
          "shape: box, size: [0.1 in, 0.2 in, 0.3 in]",
          "shape: ring_segment, "
          "outer_radius: 3.3 in, thickness: 0.07 in, width: 1 in, sector: 33 deg",
          "shape: profile, points: [[0, 0.1 in], [0.1 in, 0.1 in], [0.07 in, 0], [0, -0.3 in]]"})
        EXPECT_GT(projectile_of(std::string(keys) + ", mass: 1 g").length, 0) << keys;
    const auto cone =
        projectile_of("shape: cone, diameter: 6 mm, length: 9 mm, apex_angle: 90 deg, mass: 1 g");
    EXPECT_NEAR(cone.nose_length, 3e-3, 1e-18);
    EXPECT_DOUBLE_EQ(projectile_of("shape: box, size: [3 mm, 4 mm, 9 mm], mass: 1 g").diameter, 5e-3);
}

TEST(Profile, OfAFileIsMovedToItsNose) {
    const auto read = projectile_of("shape: profile, file: nose.csv, scale: 1 in, mass: 1 g",
                                    {{"nose.csv", "r, z\n0, 7\n2,5\n\n 2, 1\r\n0,1\n"}});
    ASSERT_EQ(read.profile.size(), 4u);
    EXPECT_EQ(read.profile[0], (std::array{0.0, 0.0}));
    EXPECT_NEAR(read.profile[1][1], -2 * 25.4e-3, 1e-15);
    EXPECT_DOUBLE_EQ(read.diameter, 4 * 25.4e-3);
    EXPECT_NEAR(read.length, 6 * 25.4e-3, 1e-15);
    EXPECT_NE(refusal_of("shape: profile, file: nose.csv, mass: 1 g", {{"nose.csv", "r, z\n0, 7\nx,5\n"}})
                  .find("nose.csv:3: found 'x,5', allowed two numbers r, z"),
              std::string::npos);
}

TEST(Profile, WithAHollowNoseStartsWithItsRimAtTheFabric) {
    const auto hollow = projectile_of(
                   "shape: profile, points: [[0, 0], [2 mm, 1 mm], [2 mm, -5 mm], [0, -5 mm]], "
                   "mass: 1 g"),
               flat = projectile_of(
                   "shape: profile, points: [[0, 0], [2 mm, 0], [2 mm, -5 mm], [0, -5 mm]], "
                   "mass: 1 g");
    EXPECT_NEAR(hollow.position[2], flat.position[2] - 1e-3, 1e-18);
}

/// Corners of a pyramid about the z axis with a square base, as an STL file numbers them.
const std::vector<std::array<std::array<float, 3>, 3>> pyramid = [] {
    const std::array<float, 3> a{1, 1, 0}, b{-1, 1, 0}, c{-1, -1, 0}, d{1, -1, 0}, top{0, 0, 3};
    return std::vector{std::array{a, b, top}, std::array{b, c, top}, std::array{c, d, top},
                       std::array{d, a, top}, std::array{a, c, b},   std::array{a, d, c}};
}();

template <class Facets>
std::string ascii(const Facets& facets) {
    std::string text = "solid pyramid\n";
    for (const auto& corners : facets) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const auto& [x, y, z] : corners) text += fmt::format("  vertex {} {:e} {}\n", x, y, z);
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid pyramid\n";
}

template <class Facets>
std::string binary(const Facets& facets) {
    std::string bytes(80, ' ');
    const auto add = [&](const auto& value) {
        const auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
        bytes.append(raw.data(), raw.size());
    };
    add(static_cast<std::uint32_t>(facets.size()));
    for (const auto& corners : facets) {
        for (int i = 0; i < 3; ++i) add(0.0F);
        for (const auto& point : corners)
            for (const float x : point) add(x);
        bytes.append(2, '\0');
    }
    return bytes;
}

const std::string mesh = "shape: mesh, file: a.stl, mass: 1 g";

TEST(Stl, AsciiAndBinaryGiveTheSameSurface) {
    const auto from_ascii = projectile_of(mesh, {{"a.stl", ascii(pyramid)}}),
               from_binary = projectile_of(mesh, {{"a.stl", binary(pyramid)}});
    EXPECT_EQ(from_ascii.triangles.points, from_binary.triangles.points);
    EXPECT_EQ(from_ascii.triangles.corners, from_binary.triangles.corners);
    EXPECT_EQ(from_ascii.triangles.points.size(), 5u);
    EXPECT_EQ(from_ascii.triangles.corners.size(), 6u);
    EXPECT_NEAR(from_ascii.length, 3e-3, 1e-18);
    EXPECT_NEAR(from_ascii.diameter, 2e-3 * std::sqrt(2.0), 1e-18);
    double top = -1;
    for (const auto& point : from_ascii.triangles.points) top = std::max(top, point[2]);
    EXPECT_EQ(top, 0);
    EXPECT_NEAR(projectile_of(mesh + ", scale: 1 in", {{"a.stl", ascii(pyramid)}}).length, 3 * 25.4e-3,
                1e-15);
}

void expect_fault(const std::string& bytes, const std::string& says) {
    const auto refusal = refusal_of(mesh, {{"a.stl", bytes}});
    EXPECT_NE(refusal.find(says), std::string::npos) << refusal;
}

TEST(Stl, ASurfaceOfAnyNumbersIsResolvedBitForBit) {
    auto facets = pyramid;
    for (auto& corners : facets)
        for (auto& point : corners)
            point = {0.7137F * point[0], 0.9173F * point[1], 1.3719F * point[2] + 0.317F};
    EXPECT_GT(projectile_of(mesh + ", scale: 0.777 in", {{"a.stl", binary(facets)}}).length, 0);
}

TEST(Stl, BadTrianglesAreNamedByNumber) {
    auto facets = pyramid;
    facets.erase(facets.begin() + 1);
    expect_fault(ascii(facets),
                 "a.stl: triangle 1: open edge: found no other triangle along (-1, 1, 0) to (0, 0, 3)");
    facets = pyramid;
    std::swap(facets[2][0], facets[2][1]);
    expect_fault(binary(facets),
                 "triangle 3: flipped against triangle 2: both run the same way along their edge");
    facets = pyramid;
    facets[3][2] = facets[3][0];
    expect_fault(binary(facets), "a.stl: triangle 4: degenerate: found no area at (1, -1, 0)");
    facets = pyramid;
    for (auto& corners : facets) std::swap(corners[0], corners[1]);
    expect_fault(binary(facets), "a.stl: found triangles that look inward");
    facets = pyramid;
    for (auto& corners : facets)
        for (auto& point : corners) point[0] += 5;
    expect_fault(binary(facets), "a.stl: found a surface that the z axis misses");
}

TEST(Stl, WhatIsNoStlFileIsRefused) {
    expect_fault("P6 640 480", "a.stl: found 10 bytes, allowed an STL file, ASCII or binary");
    auto bytes = binary(pyramid);
    bytes.pop_back();
    expect_fault(bytes, "a.stl: found 383 bytes, 384 for the 6 triangles of its header");
    auto text = ascii(pyramid);
    expect_fault(text.substr(0, text.find("endsolid")),
                 "found no 'endsolid' after triangle 6: the file is cut off");
    expect_fault(with(text, "vertex 1 ", "vertex one "), "triangle 1: found 'one', allowed a number");
}

TEST(Stl, ASymmetryNeedsASurfaceThatIsItsMirrorImage) {
    auto facets = pyramid;
    for (auto& corners : facets)
        for (auto& point : corners)
            if (point[2] == 0 && point[0] > 0) point[0] = 1.5F;
    EXPECT_EQ(refusal_of(mesh, {{"a.stl", binary(pyramid)}}), "");
    const auto refusal = refusal_of(mesh, {{"a.stl", binary(facets)}});
    EXPECT_NE(refusal.find("allowed one that is its own mirror image about x = 0 with symmetry x"),
              std::string::npos)
        << refusal;
    EXPECT_EQ(refusal.find("about y = 0"), std::string::npos) << refusal;
}

TEST(ProjectileLibrary, HoldsProjectilesThatCanBeComputed) {
    ASSERT_GE(projectile_library().size(), 12u);
    for (const auto& known : projectile_library()) {
        const auto projectile = projectile_of("standard: " + known.name);
        EXPECT_GT(projectile.mass, 0) << known.name;
        EXPECT_FALSE(known.title.empty());
        for (const auto& value : known.values) EXPECT_FALSE(value.source.empty()) << known.name << value.key;
    }
}

TEST(ProjectileLibrary, ValuesOfTheSceneReplaceThoseOfTheLibrary) {
    const auto plain = projectile_of("standard: rcc_16gr"),
               heavy = projectile_of("standard: rcc_16gr, mass: 2 g");
    EXPECT_NEAR(plain.mass, 16 * 64.79891e-6, 1e-15);
    EXPECT_EQ(heavy.mass, 2e-3);
    EXPECT_EQ(heavy.diameter, plain.diameter);
    EXPECT_EQ(projectile_of("standard: rcc_16gr", {}, {"projectile.length=9 mm"}).length, 9e-3);
    EXPECT_EQ(projectile_of("standard: rcc_16gr", {}, {"projectile.standard=fsp_22"}).shape, Shape::fsp);
}

TEST(ProjectileLibrary, NamesTheNearestProjectile) {
    const auto refusal = refusal_of("standard: fsp22");
    EXPECT_NE(refusal.find("projectile.standard: found 'fsp22', allowed fsp_22, fsp_30, "), std::string::npos)
        << refusal;
    EXPECT_NE(refusal.find("did you mean 'fsp_22'?"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace weavefront::scene::test
