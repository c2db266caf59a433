#include "weavefront/body/rigid_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace weavefront::body {
namespace {

Inertia asymmetric() { return {0.0028, {0, 0, -0.003}, {Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 3)}}; }

/// sn, cn, dn of Jacobi by descending Landen steps (Abramowitz and Stegun 16.4).
struct Elliptic {
    double sn, cn, dn;
};
Elliptic jacobi(double u, double m) {
    constexpr int steps = 12;
    std::array<double, steps + 1> a{}, c{};
    a[0] = 1, c[0] = std::sqrt(m);
    double b = std::sqrt(1 - m);
    for (std::size_t n = 0; n < steps; ++n) {
        a[n + 1] = (a[n] + b) / 2;
        c[n + 1] = (a[n] - b) / 2;
        b = std::sqrt(a[n] * b);
    }
    double phi = std::ldexp(a[steps] * u, steps), before = phi;
    for (std::size_t n = steps; n > 0; --n) {
        before = phi;
        phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2;
    }
    return {std::sin(phi), std::cos(phi), std::cos(phi) / std::cos(before - phi)};
}

/// Angular velocity in body axes of the body with moments 1, 2, 3 and w(0) = (a, 0, c), at a time (Landau and
/// Lifshitz, Mechanics, section 37). Holds where the energy times 2 J2 is less than L^2.
Vec3 closed_form(double a, double c, double time) {
    const double J1 = 1, J2 = 2, J3 = 3;
    const double E2 = J1 * a * a + J3 * c * c, L2 = J1 * J1 * a * a + J3 * J3 * c * c;
    const double rate = std::sqrt((J3 - J2) * (L2 - E2 * J1) / (J1 * J2 * J3));
    const double m = (J2 - J1) * (E2 * J3 - L2) / ((J3 - J2) * (L2 - E2 * J1));
    const auto [sn, cn, dn] = jacobi(rate * time, m);
    return {std::sqrt((E2 * J3 - L2) / (J1 * (J3 - J1))) * cn,
            std::sqrt((E2 * J3 - L2) / (J2 * (J3 - J2))) * sn,
            std::sqrt((L2 - E2 * J1) / (J3 * (J3 - J1))) * dn};
}

double error_of_top(int steps) {
    RigidBody top(asymmetric(), true);
    top.place({0, 0, 0}, Attitude(), {0, 0, 0});
    const double a = 0.7, c = 1.1, end = 10;
    top.spin({a, 0, c});
    for (int i = 0; i < steps; ++i) top.move(end / steps);
    return (top.attitude().to_body(top.angular_velocity()) - closed_form(a, c, end)).norm();
}

TEST(RigidBody, FollowsTheClosedFormOfTheFreeTopToSecondOrder) {
    const double coarse = error_of_top(1000), fine = error_of_top(2000);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.02);
}

TEST(RigidBody, KeepsAngularMomentumAndEnergyOfAFreeTopToRounding) {
    RigidBody top(asymmetric(), true);
    const Vec3 start(0.01, -0.02, -0.03), v(3, 4, 400);
    top.place(start, Attitude({0.8, 0.1, -0.5, 0.3}), v);
    top.spin({2e3, 9e3, -5e3});
    const Vec3 momentum = top.angular_momentum(), centre = top.centre();
    const double energy = top.kinetic_energy({}, 0);
    const double dt = 1e-7;
    double most = 0;
    for (int i = 0; i < 100000; ++i) {
        top.move(dt);
        most = std::max(most, std::abs(top.kinetic_energy({}, dt) / energy - 1));
    }
    EXPECT_EQ(top.angular_momentum(), momentum);
    // Each step rounds the attitude to a few 1e-16; these errors add up as a random walk.
    EXPECT_LT(most, 10 * 2.2e-16 * std::sqrt(100000.0));
    // Each step rounds a position of up to 4 m.
    EXPECT_LT((top.centre() - (centre + 1e5 * dt * v)).norm(), 1e5 * 2.2e-16 * 4);
    double length = 0;
    for (const double part : top.attitude().quaternion()) length += part * part;
    EXPECT_NEAR(length, 1, 1e-15);
}

TEST(RigidBody, TakesTheWorkOfAMomentAsEnergy) {
    RigidBody body(asymmetric(), true);
    body.place({0, 0, 0}, Attitude({0.8, 0.1, -0.5, 0.3}), {0, 0, 0});
    body.spin({30, 10, -20});
    const double dt = 1e-3, before = body.kinetic_energy({}, 0);
    double work = 0;
    for (int i = 0; i < 1000; ++i) {
        const Wrench wrench{{0, 0, 0}, {std::sin(0.01 * i), 1, 0.5 * std::cos(0.02 * i)}};
        work += wrench.moment.dot(body.angular_velocity()) * dt / 2;
        body.accelerate(wrench, dt);
        work += wrench.moment.dot(body.angular_velocity()) * dt / 2;
        body.move(dt);
    }
    EXPECT_NEAR(body.kinetic_energy({}, dt), before + work, 1e-12 * before);
    EXPECT_GT(std::abs(work), 0.005 * before);
}

TEST(RigidBody, TurnsASteadySpinByTheAngleOfTheCayleyTransform) {
    RigidBody body(asymmetric(), true);
    body.place({0, 0, 0}, Attitude(), {0, 0, 0});
    body.spin({0, 0, 7});
    const double dt = 0.01;
    for (int i = 0; i < 100; ++i) body.move(dt);
    const double angle = 100 * 2 * std::atan(7 * dt / 2);
    EXPECT_NEAR(body.attitude().row(0).x(), std::cos(angle), 1e-13);
    EXPECT_NEAR(body.attitude().row(1).x(), std::sin(angle), 1e-13);
    EXPECT_LT((body.centre() - Vec3(0, 0, -0.003)).norm(), 1e-17);
}

TEST(RigidBody, MovesItsPointsAsItTurns) {
    RigidBody body(asymmetric(), true);
    body.place({0.1, 0.2, 0.3}, Attitude({0.8, 0.1, -0.5, 0.3}), {1, 2, 3});
    body.spin({50, -20, 30});
    const Vec3 in_body(0.01, 0.02, 0.005), point = body.to_space(in_body);
    EXPECT_LT((body.to_body(point) - in_body).norm(), 1e-16);
    const Vec3 velocity = body.motion().at(point);
    const double dt = 1e-7;
    body.move(dt);
    const Vec3 moved = body.to_space(in_body);
    EXPECT_LT(((moved - point) / dt - velocity).norm(), 1e-4 * velocity.norm());
}

TEST(RigidBody, KeepsItsAttitudeWhereItDoesNotTurn) {
    RigidBody body(asymmetric(), false);
    body.place({0.1, 0.2, 0.3}, Attitude(), {1, 2, 3});
    body.accelerate({{0, 0, 28}, {1, 1, 1}}, 1e-6);
    body.move(1e-6);
    EXPECT_EQ(body.attitude().quaternion(), (std::array<double, 4>{1, 0, 0, 0}));
    EXPECT_EQ(body.velocity(), Vec3(1, 2, 3 + 1e-6 / 0.0028 * 28));
    EXPECT_EQ(body.angular_velocity(), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace weavefront::body
