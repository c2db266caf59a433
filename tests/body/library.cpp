/// The projectiles of the library have the density of their material.

#include "weavefront/scene/library.hpp"

#include <gtest/gtest.h>

#include "weavefront/body/shape.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::test {
namespace {

double density_of(const std::string& name) {
    const auto scene = scene::parse_scene(
        "fabrics: {a: {library: kevlar_km2_s706}}\ncontact: {projectile: {}}\nprojectile: {standard: " +
            name + ", velocity: [0, 0, 100 m/s]}\n",
        "s.yaml", {}, scene::Need::fabrics);
    const auto& projectile = scene.projectiles.front();
    return projectile.mass / body::make_shape(projectile)->mass_properties().volume;
}

TEST(ProjectileLibrary, WeighsAsItsMaterial) {
    for (const auto& known : scene::projectile_library()) {
        const auto begins = [&](const char* prefix) { return known.name.starts_with(prefix); };
        // fragments: dimensions have four digits, and chords take 0.07 % of the volume
        if (begins("fsp") || begins("rcc")) {
            EXPECT_NEAR(density_of(known.name), 7850, 8) << known.name;
        }
        if (begins("sphere")) {
            EXPECT_NEAR(density_of(known.name), 7800, 2) << known.name;
        }
        // bullets: lead of 11300 in a jacket of 8900 kg/m3
        if (begins("nij")) {
            EXPECT_GT(density_of(known.name), 9800) << known.name;
            EXPECT_LT(density_of(known.name), 11300) << known.name;
        }
    }
}

}  // namespace
}  // namespace weavefront::test
