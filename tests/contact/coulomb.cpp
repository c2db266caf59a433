/// Coulomb friction of one point.

#include "weavefront/contact/coulomb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using contact::CoulombLaw;
using contact::TangentialTraction;

constexpr double k_n = 5e12, ratio = 0.8, k_t = ratio * k_n, of_static = 0.3, of_kinetic = 0.2, p = 1e8;
constexpr double first_slip = of_static * p / k_t;  // m
const CoulombLaw law({.static_coefficient = of_static, .kinetic_coefficient = of_kinetic}, k_n);

/// Moves the master along x in `steps` equal steps; returns the traction and adds to the work done on it.
double slide(TangentialTraction& point, double way, int steps, double pressure, double* work = nullptr) {
    for (int i = 0; i < steps; ++i) {
        const double before = point.traction.x(), step = way / steps;
        law.advance(point, Vec3::UnitZ(), pressure, {Vec3(step, 0, 0), Vec3::Zero()});
        if (work) *work += (before + point.traction.x()) / 2 * step;
    }
    return point.traction.x();
}

TEST(CoulombLaw, SticksSlipsAndSticksAgainWhenTheSlipReverses) {
    TangentialTraction point;
    EXPECT_NEAR(slide(point, 0.5 * first_slip, 10, p), 0.5 * of_static * p, 1e-12 * p);
    EXPECT_NEAR(slide(point, 0.49 * first_slip, 10, p), 0.99 * of_static * p, 1e-12 * p);
    EXPECT_NEAR(slide(point, 0.02 * first_slip, 1, p), of_kinetic * p, 1e-12 * p);
    EXPECT_NEAR(slide(point, 5 * first_slip, 50, p), of_kinetic * p, 1e-12 * p);
    EXPECT_TRUE(point.slips);
    EXPECT_NEAR(slide(point, -0.1 * first_slip, 1, p), of_kinetic * p - 0.1 * of_static * p, 1e-12 * p);
    EXPECT_FALSE(point.slips);
    // It sticks up to the static coefficient on the other side.
    const double to_slip = (of_kinetic + of_static) / of_static - 0.1;
    EXPECT_NEAR(slide(point, -(to_slip - 0.01) * first_slip, 20, p), -0.99 * of_static * p, 1e-12 * p);
    EXPECT_NEAR(slide(point, -0.02 * first_slip, 1, p), -of_kinetic * p, 1e-12 * p);
}

TEST(CoulombLaw, FollowsThePressureAndHasNoTractionWithoutIt) {
    TangentialTraction point;
    slide(point, 0.9 * first_slip, 10, p);
    EXPECT_NEAR(slide(point, 0, 1, 0.5 * p), of_kinetic * 0.5 * p, 1e-12 * p)
        << "the cap has fallen below it";
    EXPECT_NEAR(slide(point, 0, 1, p), of_kinetic * 0.5 * p, 1e-12 * p) << "what is lost does not come back";
    EXPECT_EQ(slide(point, first_slip, 1, 0), 0);
    EXPECT_FALSE(point.slips);
    EXPECT_NEAR(slide(point, 0.5 * first_slip, 1, p), 0.5 * of_static * p, 1e-12 * p) << "it starts afresh";
}

TEST(CoulombLaw, TakesTheStoredEnergyWhileItSticksAndForceTimesWayWhileItSlips) {
    TangentialTraction point;
    double work = 0;
    slide(point, 0.99 * first_slip, 10, p, &work);
    const double stored = law.elastic_energy(point);
    EXPECT_NEAR(work, stored, 1e-12 * stored);
    slide(point, 0.02 * first_slip, 1, p);
    work = 0;
    slide(point, 10 * first_slip, 100, p, &work);
    EXPECT_NEAR(work, of_kinetic * p * 10 * first_slip, 1e-12 * work);
}

// Less than nothing is dissipated only by a step whose slip reverses and exceeds the cap by itself, k_t d^2/8
// at the most. A turn by an angle of a step turns the mean traction by half of it.
TEST(CoulombLaw, CreatesNoEnergyOnRandomPaths) {
    std::mt19937_64 random(5);
    const auto any = [&](double size) {
        return Vec3(uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size));
    };
    for (const double of_step : {0.01, 0.3, 5.0}) {  // of the way to the first slip
        double slipped = 0;
        for (int path = 0; path < 100; ++path) {
            TangentialTraction point;
            Vec3 normal = any(1).normalized(), rate = Vec3::Zero();
            double work = 0, allowed = 0, pressure = 0, pressing = 0;
            for (int n = 0; n < 2000; ++n) {
                if (n % 20 == 0) rate = any(of_step * first_slip), pressing = uniform(random, -0.1, 0.1) * p;
                pressure = std::clamp(pressure + pressing, -0.1 * p, p);
                const Vec3 turn = any(1e-3);
                normal = (normal + turn.cross(normal)).normalized();
                const Vec3 before = point.traction;
                law.advance(point, normal, std::max(pressure, 0.0), {rate, turn});
                ASSERT_LT(std::abs(point.traction.dot(normal)), 1e-14 * p);
                ASSERT_LE(point.traction.norm(), of_static * std::max(pressure, 0.0) * (1 + 1e-14));
                work += (before + point.traction).dot(rate) / 2;
                allowed += k_t * rate.squaredNorm() / 8 * (k_t * rate.norm() > of_kinetic * pressure) +
                           before.norm() * turn.norm() * rate.norm() + 1e-14 * of_static * p * rate.norm();
                ASSERT_GE(work - law.elastic_energy(point), -allowed) << path << ' ' << n;
                slipped += point.slips ? 1 : 0;
            }
        }
        EXPECT_GT(slipped, 0);
    }
}

/// A rotation by an angle about a unit axis.
Vec3 rotated(const Vec3& v, const Vec3& axis, double angle) { return Eigen::AngleAxisd(angle, axis) * v; }

TEST(CoulombLaw, TurnsWithEverything) {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    const Vec3 axis = Vec3(0.3, -0.7, 0.5).normalized();
    const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(1e-3, 1e-4, 0), Vec3(1.2e-3, 0.9e-3, 0),
                                      Vec3(-1e-4, 1.1e-3, 0)};
    constexpr double per_step = 0.01, dt = 1e-7;
    constexpr int steps = 300;
    TangentialTraction still, turning;
    for (int n = 1; n <= steps; ++n) {
        const Vec3 way(0.02 * first_slip * std::cos(0.05 * n), 0.02 * first_slip * std::sin(0.1 * n), 0);
        law.advance(still, Vec3::UnitZ(), p, {way, Vec3::Zero()});
        std::array<Vec3, 4> now, velocities;
        for (std::size_t a = 0; a < 4; ++a) {
            now[a] = rotated(corners[a], axis, per_step * n);
            velocities[a] = (now[a] - rotated(corners[a], axis, per_step * (n - 1))) / dt;
        }
        law.advance(turning, rotated(Vec3::UnitZ(), axis, per_step * n), p,
                    {rotated(way, axis, per_step * n), contact::turn_of(now, velocities, dt)});
        const Vec3 expected = rotated(still.traction, axis, per_step * n);
        // Some ten operations a step; the difference of positions over a step loses 1/per_step of them.
        ASSERT_LT((turning.traction - expected).norm(), 10 * u / per_step * n * of_static * p) << n;
    }
    EXPECT_GT(still.traction.norm(), 0.05 * p);
}

}  // namespace
}  // namespace weavefront::test
