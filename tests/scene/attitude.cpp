#include <gtest/gtest.h>

#include <cmath>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

/// The projectile of the example before a whole target.
Projectile projectile(std::vector<std::string> overrides) {
    overrides.emplace_back("target.symmetry=[]");
    return parse(example, overrides).projectiles.front();
}

/// Where the attitude turns an axis of the body.
std::array<double, 3> turned(const Projectile& projectile, std::array<double, 3> v) {
    const auto [w, x, y, z] = projectile.attitude;
    const std::array<double, 3> t{2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]),
                                  2 * (x * v[1] - y * v[0])};
    return {v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]};
}

void expect_near(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-15) << i;
}

TEST(Attitude, YawTurnsTheNoseTowardsXAndPitchTowardsY) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    expect_near(turned(projectile({"projectile.orientation={yaw: 0.3 rad}"}), {0, 0, 1}), {s, 0, c});
    expect_near(turned(projectile({"projectile.orientation={pitch: 0.3 rad}"}), {0, 0, 1}), {0, s, c});
}

TEST(Attitude, RollComesFirst) {
    const auto rolled = projectile({"projectile.orientation={roll: 90 deg, yaw: 0.3 rad}"});
    expect_near(turned(rolled, {0, 0, 1}), {std::sin(0.3), 0, std::cos(0.3)});
    expect_near(turned(rolled, {1, 0, 0}), {0, 1, 0});
}

TEST(Attitude, OfAnAxisAndAnAngleIsRightHanded) {
    expect_near(turned(projectile({"projectile.orientation={axis: [0, 7, 0], angle: 90 deg}"}), {0, 0, 1}),
                {1, 0, 0});
}

TEST(Attitude, OfAQuaternionIsNormalised) {
    const auto q = projectile({"projectile.orientation={quaternion: [3, 0, 4, 0]}"}).attitude;
    EXPECT_DOUBLE_EQ(q[0], 0.6);
    EXPECT_DOUBLE_EQ(q[2], 0.8);
}

TEST(Attitude, SpinIsAboutTheProjectilesOwnAxis) {
    const auto spinning =
        projectile({"projectile.orientation={yaw: 90 deg}", "projectile.spin=60 rpm"}).angular_velocity;
    EXPECT_NEAR(spinning[0], 2 * 3.14159265358979323846, 1e-14);
    EXPECT_NEAR(spinning[2], 0, 1e-14);
}

TEST(Attitude, IsFixedOnRequestAndByTwoPlanesOfSymmetry) {
    EXPECT_TRUE(projectile({}).turns);
    EXPECT_FALSE(projectile({"projectile.fixed=rotation"}).turns);
    EXPECT_FALSE(parse(example, {"target.symmetry=[x, y]"}).projectiles.front().turns);
    EXPECT_TRUE(parse(example, {"target.symmetry=[x]"}).projectiles.front().turns);
}

TEST(Attitude, LeavesRoomForTheInclinedProjectileBeforeTheTarget) {
    const auto upright = projectile({}), inclined = projectile({"projectile.orientation={yaw: 30 deg}"}),
               backwards = projectile({"projectile.orientation={yaw: 180 deg}"});
    EXPECT_NEAR(upright.position[2] - inclined.position[2], upright.diameter / 2 * std::sin(M_PI / 6), 1e-15);
    EXPECT_NEAR(upright.position[2] - backwards.position[2], upright.length, 1e-15);
}

TEST(Attitude, ReadsBackBitForBitFromTheResolvedScene) {
    const Scene scene = parse(
        example, {"target.symmetry=[]", "projectile.orientation={yaw: 10 deg, pitch: -3 deg, roll: 77 deg}",
                  "projectile.spin=31234 rpm", "projectile.inertia=[21 g mm^2, 22 g mm^2, 9 g mm^2]"});
    const Scene again = parse(scene.resolved);
    EXPECT_EQ(again.projectiles.front().attitude, scene.projectiles.front().attitude);
    EXPECT_EQ(again.projectiles.front().angular_velocity, scene.projectiles.front().angular_velocity);
    EXPECT_EQ(again.projectiles.front().inertia, scene.projectiles.front().inertia);
    EXPECT_EQ(again.resolved, scene.resolved);
    const Scene fixed = parse(example, {"target.symmetry=[]", "projectile.fixed=rotation"});
    EXPECT_FALSE(parse(fixed.resolved).projectiles.front().turns);
}

}  // namespace
}  // namespace weavefront::scene::test
