/// The projectile response on plies.

#include "weavefront/contact/projectile_contact.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "surfaces.hpp"
#include "translating.hpp"

namespace weavefront::test {
namespace {

constexpr double k = 5e12, side = 8e-3, speed = 100, dt = 1e-8;
const scene::ContactLaw elastic{.stiffness = k, .unloading = 1, .damping = 0};

contact::Footprint nose(const Translating& state) {
    return contact::SweptBounds({&state.position, 1}).of_node(0);
}

/// Presses a projectile `depth` into a flat fixed ply at z = 0; returns the forces.
contact::PairForce total(const scene::Projectile& projectile, double spacing, double depth,
                         double thickness) {
    Plies plies;
    plies.add(8, {.z = 0, .thickness = thickness, .areal_density = 0.2}, flat(side, 0));
    contact::ProjectileContact contact(body::make_shape(projectile), Translating{}, elastic, spacing,
                                       plies.surface, plies.x);
    const Positions v(plies.x.size(), Vec3::Zero());
    Translating state{{0.013e-3, 0.021e-3, -thickness / 2 - 2.5 * speed * dt}, {0, 0, speed}};
    contact.update_candidates(plies.surface, contact::SweptBounds(plies.x), nose(state), 0.1e-3);
    contact::ContactForces forces;
    while (state.position.z() + speed * dt <= depth - thickness / 2) {
        state.position.z() += speed * dt;
        forces.clear();
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, state, dt, 1, forces);
    }
    // the last bit of the way in one short step
    const double rest = (depth - thickness / 2 - state.position.z()) / speed;
    state.position.z() = depth - thickness / 2;
    forces.clear();
    contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, state, rest, 1, forces);
    contact::PairForce sum({}, contact::Master::projectile);
    for (const auto& pair : forces.pairs) {
        Vec3 nodal = Vec3::Zero();
        for (const auto& force : pair.on_slave) nodal += force;
        EXPECT_EQ(pair.kind, contact::Master::projectile);
        EXPECT_LT((nodal - pair.total).norm(), 1e-14 * pair.total.norm());
        sum.total += pair.total;
    }
    return sum;
}

TEST(ProjectileContact, AFlatFacePushesByStiffnessDepthAndArea) {
    const double R = 2.69e-3, depth = 0.02e-3;
    const scene::Projectile cylinder{.shape = scene::Shape::cylinder, .diameter = 2 * R, .length = 10e-3};
    for (const double spacing : {0.5e-3, 0.25e-3, 0.125e-3, 0.0625e-3}) {
        const Vec3 force = total(cylinder, spacing, depth, 0).total;
        // points in a circle: the cells across its rim, 2 pi R/spacing of them, err at random
        EXPECT_NEAR(force.z() / (k * depth * std::numbers::pi * R * R), 1, std::pow(spacing / R, 1.5))
            << spacing;
        EXPECT_EQ(force.x(), 0);
        EXPECT_EQ(force.y(), 0);
    }
}

TEST(ProjectileContact, ASpherePushesByTheIntegralOfItsDepth) {
    // int k (R - r) over the circle of contact, all along the normal of the ply; R inflated by half the
    // thickness
    const double R = 2.7e-3, depth = 0.3e-3, thickness = 0.2e-3;
    const scene::Projectile sphere{.shape = scene::Shape::sphere, .diameter = 2 * R - thickness};
    const double h = R - depth;
    // with s^2 = h^2 + rho^2: int_h^R 2 pi s k (R - s) ds
    const double closed = std::numbers::pi * k * (R * (R * R - h * h) - 2.0 / 3 * (R * R * R - h * h * h));
    const double coarse = std::abs(total(sphere, 0.25e-3, depth, thickness).total.z() / closed - 1),
                 fine = std::abs(total(sphere, 0.0625e-3, depth, thickness).total.z() / closed - 1);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(fine, 0.02 / 16 + 1e-4);
}

// Points just within the rim are nearer to the side than to the face once they are in; the side would not
// press on them.
TEST(ProjectileContact, AFastFaceMeetsThePlyUpToItsRim) {
    constexpr double fast = 1000, step = 1e-7, way = fast * step;
    Plies plies;
    plies.add(8, {.z = 0, .thickness = 0, .areal_density = 0.2}, flat(side, 0));
    const scene::Projectile cylinder{.shape = scene::Shape::cylinder, .diameter = 5.38e-3, .length = 10e-3};
    /// Of the first contact, m2.
    const auto area = [&](double gap) {
        contact::ProjectileContact contact(body::make_shape(cylinder), Translating{}, elastic, 0.03e-3,
                                           plies.surface, plies.x);
        const Positions v(plies.x.size(), Vec3::Zero());
        Translating state{{0.013e-3, 0.021e-3, -gap}, {0, 0, fast}};
        contact.update_candidates(plies.surface, contact::SweptBounds(plies.x), nose(state), 0.1e-3);
        contact::ContactForces forces;
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, state, 0, 1, forces);
        while (forces.pairs.empty()) {
            state.position.z() += way;
            contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, state, step, 1, forces);
        }
        double force = 0;
        for (const auto& pair : forces.pairs) force += pair.total.z();
        return force / (k * state.position.z());
    };
    for (const double gap : {0.06e-3, 0.15e-3, 0.35e-3}) EXPECT_NEAR(area(gap) / area(0), 1, 1e-9) << gap;
}

/// The force on a ply that leans by an angle about y under the flat face, over its size.
Vec3 push_on_leaning_ply(std::optional<double> spacing, double angle) {
    Plies plies;
    const Vec3 along(std::cos(angle), 0, -std::sin(angle));
    plies.add(8, {.z = 0, .thickness = 0, .areal_density = 0.2}, [&](double u, double v) {
        return Vec3(2e-3 * (u - 0.5) * along + Vec3(0, 2e-3 * (v - 0.5), 0));
    });
    const scene::Projectile cylinder{.shape = scene::Shape::cylinder, .diameter = 5e-3, .length = 10e-3};
    contact::ProjectileContact contact(body::make_shape(cylinder), Translating{}, elastic, spacing,
                                       plies.surface, plies.x);
    const Positions v(plies.x.size(), Vec3::Zero());
    Translating state{{0, 0, -1.1e-3}, {0, 0, speed}};
    contact.update_candidates(plies.surface, contact::SweptBounds(plies.x), nose(state), 0.1e-3);
    contact::ContactForces forces;
    for (int step = 0; step < 1100; ++step) {
        state.position.z() += speed * dt;
        forces.clear();
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, state, dt, 1, forces);
    }
    return assemble(forces.pairs, plies.x).on_slaves.normalized();
}

// Without friction nothing may pull along the yarns: over the edge of a projectile the tension on both sides
// would differ.
TEST(ProjectileContact, DoesNotPullAlongThePly) {
    const double angle = 0.6;
    EXPECT_LT((push_on_leaning_ply(0.25e-3, angle) - Vec3(std::sin(angle), 0, std::cos(angle))).norm(),
              1e-12);
    EXPECT_LT((push_on_leaning_ply(0.25e-3, -angle) - Vec3(-std::sin(angle), 0, std::cos(angle))).norm(),
              1e-12);
    EXPECT_LT((push_on_leaning_ply({}, angle) - Vec3::UnitZ()).norm(), 1e-12)
        << "contact at the nodes is that of its time";
    EXPECT_LT((push_on_leaning_ply(0.25e-3, 1.2) - Vec3::UnitZ()).norm(), 1e-12) << "seen nearly edge-on";
}

TEST(ProjectileContact, TouchesNothingBesideItsFootprintOrEroded) {
    Plies plies;
    plies.add(8, {.z = 0, .thickness = 0, .areal_density = 0.2}, flat(side, 0));
    const scene::Projectile cylinder{.shape = scene::Shape::cylinder, .diameter = 5e-3, .length = 10e-3};
    contact::ProjectileContact contact(body::make_shape(cylinder), Translating{}, elastic, 0.25e-3,
                                       plies.surface, plies.x);
    const Positions v(plies.x.size(), Vec3::Zero());
    Translating state{{0, 0, -0.5e-6}, {0, 0, speed}};
    contact.update_candidates(plies.surface, contact::SweptBounds(plies.x), nose(state), 0.1e-3);
    contact::ContactForces forces;
    contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, state, dt, 1, forces);
    EXPECT_TRUE(forces.pairs.empty());
    plies.surface.alive[27] = 0;
    state.position.z() += speed * dt;
    contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, state, dt, 1, forces);
    ASSERT_FALSE(forces.pairs.empty());
    for (const auto& pair : forces.pairs) {
        EXPECT_NE(pair.slave, plies.surface.facets[27].nodes);
        Vec3 nearest = Vec3::Constant(1);
        for (const auto& corner : contact::corners_of(pair.slave, plies.x))
            if (corner.norm() < nearest.norm()) nearest = corner;
        EXPECT_LT(nearest.norm(), 2.5e-3);
    }
}

}  // namespace
}  // namespace weavefront::test
