/// Friction of the plies between the jaws of a clamp.

#include "weavefront/contact/clamp_friction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

constexpr double pressure = 2e6, mu = 0.2, stiffness = 5.6e12, area = 1e-6, dt = 1e-7;
constexpr std::size_t plies = 3;

/// Two nodes a ply, of which the second is in a clamp.
contact::ClampFriction three_plies() {
    const scene::Clamp clamp{pressure, {.static_coefficient = mu, .kinetic_coefficient = mu}};
    return {{clamp, std::nullopt}, stiffness, {{1, 0, {area, area, area}}}, 2, plies};
}

/// Forces on the plies after they have been pulled at constant speed for so long that what is pulled slips.
std::array<Vec3, plies> pulled(const std::array<Vec3, plies>& speeds) {
    auto clamp = three_plies();
    std::array<Vec3, 2 * plies> v;
    v.fill(Vec3(7, 8, 9));  // outside of the clamp
    for (std::size_t p = 0; p < plies; ++p) v[1 + 2 * p] = speeds[p];
    for (int step = 0; step < 100; ++step) clamp.evaluate(v, dt);
    std::array<Vec3, plies> forces;
    EXPECT_EQ(clamp.forces().size(), plies);
    for (std::size_t p = 0; p < plies; ++p) {
        EXPECT_EQ(clamp.forces()[p].node, 1 + 2 * p);
        forces[p] = clamp.forces()[p].force;
    }
    return forces;
}

TEST(ClampFriction, ResistsAStackThatIsPulledAlikeByFrictionOnBothJaws) {
    const Vec3 speed(0.3, -0.4, 0);
    const auto forces = pulled({speed, speed, speed});
    const Vec3 on_face = -mu * pressure * area * speed / speed.norm();
    EXPECT_LT((forces[0] - on_face).norm(), 1e-12 * on_face.norm());
    EXPECT_LT(forces[1].norm(), 1e-12 * on_face.norm()) << "its neighbours move with it";
    EXPECT_LT((forces[2] - on_face).norm(), 1e-12 * on_face.norm());
}

TEST(ClampFriction, ResistsASinglePlyByFrictionOnBothItsFaces) {
    for (std::size_t p = 0; p < plies; ++p) {
        std::array<Vec3, plies> speeds;
        speeds.fill(Vec3::Zero());
        speeds[p] = {0.5, 0, 0};
        const auto forces = pulled(speeds);
        EXPECT_NEAR(forces[p].x(), -2 * mu * pressure * area, 1e-12 * pressure * area) << p;
        for (std::size_t other = 0; other < plies; ++other)
            if (other != p) {
                const bool is_neighbour = other + 1 == p || p + 1 == other;
                EXPECT_NEAR(forces[other].x(), is_neighbour ? mu * pressure * area : 0,
                            1e-12 * pressure * area);
            }
    }
}

TEST(ClampFriction, SticksByItsStiffnessBelowTheLimit) {
    auto clamp = three_plies();
    std::array<Vec3, 2 * plies> v;
    v.fill(Vec3::Zero());
    v[1] = {1e-3, 0, 0};
    clamp.evaluate(v, dt);
    const double k_t = scene::Friction{}.stiffness_ratio * stiffness;
    EXPECT_NEAR(clamp.forces()[0].force.x(), -2 * k_t * area * 1e-3 * dt, 1e-12 * pressure * area);
}

TEST(ClampFriction, TakesEnergyOnEveryRandomPath) {
    std::mt19937_64 random(1);
    for (int path = 0; path < 100; ++path) {
        auto clamp = three_plies();
        std::array<Vec3, 2 * plies> v;
        v.fill(Vec3::Zero());
        double taken = 0, lowest = 0;
        std::array<Vec3, plies> last;
        last.fill(Vec3::Zero());
        for (int step = 0; step < 200; ++step) {
            for (std::size_t p = 0; p < plies; ++p)
                v[1 + 2 * p] = {uniform(random, -1, 1), uniform(random, -1, 1), 0};
            clamp.evaluate(v, dt);
            for (std::size_t p = 0; p < plies; ++p) {
                const Vec3& now = clamp.forces()[p].force;
                taken -= (last[p] + now).dot(v[1 + 2 * p]) * dt / 2;
                last[p] = now;
            }
            lowest = std::min(lowest, taken);
        }
        EXPECT_GT(taken, 0);
        EXPECT_GE(lowest, -1e-3 * taken) << path;
    }
}

}  // namespace
}  // namespace weavefront::test
