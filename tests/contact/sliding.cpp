/// Frictionless contact while the sides slide past each other.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "surfaces.hpp"
#include "translating.hpp"
#include "weavefront/contact/ply_contact.hpp"
#include "weavefront/contact/projectile_contact.hpp"
#include "weavefront/contact/sliding_account.hpp"

namespace weavefront::test {
namespace {

constexpr double k = 5.6e12, speed = 20, mass = 0.9e-3, dt = 2e-8;

scene::ContactLaw law(double unloading) { return {.stiffness = k, .unloading = unloading, .damping = 0}; }

/// Books what facets report, as the solver does.
void book(contact::SlidingAccount& account, const contact::ContactForces& forces) {
    constexpr double scale = 0x1p60;
    std::int64_t released = 0, wanted = 0;
    for (const auto& facet : forces.sliding) {
        released += std::llround(scale * (facet.released - facet.taken));
        wanted += std::llround(scale * facet.wanted);
    }
    account.book(released, wanted);
}

/// What a rebound leaves.
struct Rebound {
    double normal, along;  ///< velocity away from the plane and along it, m/s
    double depth;          ///< largest, m
};

/// Lets a projectile meet an immovable plane at 20 m/s along its normal while it slides along it.
/// @param tilt of the plane about y, rad
Rebound meet_plane(const scene::Projectile& projectile, double unloading, double sliding, double tilt,
                   double spacing = 0.25e-3) {
    const Vec3 along(std::cos(tilt), 0, -std::sin(tilt)), normal(std::sin(tilt), 0, std::cos(tilt));
    constexpr double length = 24e-3, width = 8e-3;
    Plies plies;
    plies.add(32, {.z = 0, .thickness = 0.14e-3, .areal_density = 0.2}, [&](double u, double v) {
        return Vec3(length * (u - 0.5) * along + width * (v - 0.5) * Vec3::UnitY());
    });
    contact::ProjectileContact contact(body::make_shape(projectile), Translating{}, law(unloading), spacing,
                                       plies.surface, plies.x);
    const Positions at_rest(plies.x.size(), Vec3::Zero());
    const double radius = projectile.diameter / 2, gap = 0.07e-3 + 1e-6;
    // The point of the projectile that meets the plane first stands over its middle, less half of the way
    // that it slides.
    const Vec3 first =
        projectile.shape == scene::Shape::sphere ? Vec3(radius * (normal - Vec3::UnitZ())) : Vec3::Zero();
    Translating state{Vec3(-gap * normal - first - sliding * 12e-6 * along),
                      Vec3(speed * normal + sliding * along)};
    contact::SlidingAccount account;
    contact::ContactForces forces;
    Rebound rebound{};
    for (int step = 0; step < 2500; ++step) {
        contact.update_candidates(plies.surface, contact::SweptBounds(plies.x),
                                  contact::SweptBounds({&state.position, 1}).of_node(0), 1e-3);
        forces.clear();
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, at_rest, state, dt,
                         account.sliding_share(), forces);
        book(account, forces);
        for (const auto& pair : forces.pairs) state.velocity -= dt / mass * pair.total;
        state.position += dt * state.velocity;
        rebound.depth = std::max(rebound.depth, (state.position + first).dot(normal) + 0.07e-3);
    }
    rebound.normal = -state.velocity.dot(normal), rebound.along = state.velocity.dot(along);
    return rebound;
}

const scene::Projectile sphere{.shape = scene::Shape::sphere, .diameter = 6e-3};
const scene::Projectile cylinder{
    .shape = scene::Shape::cylinder, .diameter = 5.38e-3, .edge_radius = 0.3e-3, .length = 10e-3};

/// Height of a wave over a length.
struct Wave {
    double height, length;  ///< m
    double operator()(double at) const { return height * std::cos(2 * std::numbers::pi * at / length); }
};

/// Lets a wavy ply of the given mass per area bounce on another one, immovable, that is wavy across the
/// first; both keep their shapes.
/// @param sliding of the moving ply along its own waves or across them: then the waves of either side pass
/// over the other, m/s
Rebound bounce_on_waves(double unloading, const Vec3& sliding, int facets, bool upper_moves) {
    constexpr double side = 10e-3, thickness = 0.2e-3, density = 0.2, approach = 20, step_length = 1e-8;
    const Wave wave{0.05e-3, side / 4};
    Plies plies;
    const contact::PlyProperties of_ply{.z = 0, .thickness = thickness, .areal_density = density};
    plies.add(facets, of_ply,
              [&](double u, double v) { return Vec3(side * (u - 0.5), side * (v - 0.5), wave(side * u)); });
    const auto first = plies.x.size();
    const double gap = thickness + 2 * wave.height + 1e-6, wide = 2 * side;
    plies.add(
        2 * facets, {.z = gap, .thickness = thickness, .areal_density = density},
        [&](double u, double v) { return Vec3(wide * (u - 0.5), wide * (v - 0.5), gap + wave(wide * v)); });
    contact::PlyContact contact(law(unloading), 0.0625e-3, plies.surface, plies.x);
    contact::SlidingAccount account;
    contact::ContactForces forces;
    Vec3 velocity =
        upper_moves ? Vec3(sliding + approach * Vec3::UnitZ()) : Vec3(-sliding - approach * Vec3::UnitZ());
    Positions v(plies.x.size(), Vec3::Zero());
    const std::size_t begin = upper_moves ? 0 : first, end = upper_moves ? first : plies.x.size();
    double depth = 0, way = 0;
    for (int step = 0; step < 1500; ++step) {
        if (step % 20 == 0)
            contact.update_candidates(plies.surface, contact::SweptBounds(plies.x), plies.x, 1.5e-3);
        forces.clear();
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, step > 0 ? step_length : 0,
                         account.sliding_share(), forces);
        book(account, forces);
        Vec3 force = Vec3::Zero();
        for (const auto& pair : forces.pairs) force += pair.total;
        velocity += step_length / (density * side * side) * (upper_moves ? force : Vec3(-force));
        for (std::size_t n = begin; n < end; ++n) v[n] = velocity, plies.x[n] += step_length * velocity;
        way += step_length * (upper_moves ? velocity.z() : -velocity.z());
        depth = std::max(depth, way);
    }
    const double sign = upper_moves ? -1 : 1;
    return {sign * velocity.z(), velocity.head<2>().norm(), depth};
}

constexpr std::array sliding_speeds{20.0, 100.0, 400.0};  // m/s, up to twenty times the approach

TEST(Sliding, ChangesNoElasticReboundFromAPlane) {
    for (const double tilt : {0.0, 0.5})
        for (const double sliding : sliding_speeds) {
            const auto rebound = meet_plane(sphere, 1, sliding, tilt);
            EXPECT_NEAR(rebound.normal / speed, 1, 0.01) << sliding << ' ' << tilt;
            EXPECT_NEAR(rebound.along, sliding, 1e-9 * sliding) << sliding << ' ' << tilt;
        }
    for (const double sliding : sliding_speeds)
        EXPECT_NEAR(meet_plane(cylinder, 1, sliding, 0).normal / speed, 1, 0.01) << sliding;
}

TEST(Sliding, ChangesNoHystereticReboundFromAPlane) {
    for (const auto* projectile : {&sphere, &cylinder}) {
        const double straight = meet_plane(*projectile, 10, 0, 0).normal;
        EXPECT_NEAR(straight * std::sqrt(10) / speed, 1, 0.01);
        for (const double sliding : sliding_speeds)
            EXPECT_NEAR(meet_plane(*projectile, 10, sliding, 0).normal / straight, 1, 0.02) << sliding;
    }
    EXPECT_NEAR(meet_plane(sphere, 10, 400, 0.5).normal * std::sqrt(10) / speed, 1, 0.02);
}

/// Presses a sphere that moves at a slant into a ply that is wrapped around it, or lies flat before it;
/// returns the direction of the force.
Vec3 push_of_sphere(bool wrapped) {
    const double R = sphere.diameter / 2 + 0.07e-3;
    Plies plies;
    plies.add(8, {.z = 0, .thickness = 0.14e-3, .areal_density = 0.2}, [&](double u, double v) {
        const Vec3 flat(3e-3 * u, 4e-3 * (v - 0.5), 0);
        return wrapped ? Vec3(R * (flat + R * Vec3::UnitZ()).normalized() - R * Vec3::UnitZ()) : flat;
    });
    contact::ProjectileContact contact(body::make_shape(sphere), Translating{}, law(1), 0.25e-3,
                                       plies.surface, plies.x);
    const Vec3 velocity(100, 0, 20);
    Translating state{-40 * dt * velocity - Vec3(0, 0, 0.07e-3), velocity};
    contact.update_candidates(plies.surface, contact::SweptBounds(plies.x),
                              contact::SweptBounds({&state.position, 1}).of_node(0), 1e-3);
    contact::ContactForces forces;
    for (int step = 0; step < 60; ++step) {
        state.position += dt * velocity;
        forces.clear();
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x,
                         Positions(plies.x.size(), Vec3::Zero()), state, dt, 1, forces);
    }
    return assemble(forces.pairs, plies.x).on_slaves.normalized();
}

// A flat ply is not pulled along; a ply around the sphere stands in its way.
TEST(Sliding, IsResistedByAPlyThatIsWrappedAroundTheSphere) {
    EXPECT_LT((push_of_sphere(false) - Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_GT(push_of_sphere(true).x(), 0.3);
}

TEST(Sliding, LeavesTheDepthOfTheSphereWhereItsEnergyPutsIt) {
    // int k (R - r) over the circle of contact is pi k (R d^2 - 2/3 d^3); its work up to the depth d is m
    // v^2/2
    const double R = sphere.diameter / 2 + 0.07e-3, d = 0.21804e-3;
    ASSERT_NEAR(std::numbers::pi * k * (R * d * d * d / 3 - d * d * d * d / 6) / (mass * speed * speed / 2),
                1, 1e-4);
    for (const double sliding : {0.0, 400.0}) {
        const double coarse = std::abs(meet_plane(sphere, 1, sliding, 0, 0.5e-3).depth / d - 1),
                     fine = std::abs(meet_plane(sphere, 1, sliding, 0, 0.125e-3).depth / d - 1);
        EXPECT_LT(coarse, 0.02) << sliding;
        EXPECT_LT(fine, 0.005) << sliding;
    }
}

TEST(Sliding, OfACurvedPlyOverAnotherChangesNoElasticRebound) {
    for (const bool upper_moves : {true, false}) {
        EXPECT_NEAR(bounce_on_waves(1, {400, 0, 0}, 20, upper_moves).normal / speed, 1, 0.02);
        EXPECT_NEAR(bounce_on_waves(1, {0, 400, 0}, 20, upper_moves).normal / speed, 1, 0.02);
    }
    EXPECT_NEAR(bounce_on_waves(1, {280, 280, 0}, 40, true).normal / speed, 1, 0.01);
}

TEST(Sliding, OfACurvedPlyOverAnotherGivesNoEnergy) {
    const double straight = bounce_on_waves(10, {0, 0, 0}, 20, true).normal;
    EXPECT_NEAR(straight * std::sqrt(10) / speed, 1, 0.01);
    // Waves of the ply that is passed over.
    EXPECT_NEAR(bounce_on_waves(10, {0, 400, 0}, 20, true).normal / straight, 1, 0.03);
    // Waves of the ply whose points look for the other: their normals count sliding as approach, so that less
    // is lost.
    const auto along = bounce_on_waves(10, {400, 0, 0}, 20, true);
    EXPECT_GT(along.normal, straight);
    EXPECT_LT(along.normal * along.normal + along.along * along.along, speed * speed + 400 * 400);
}

}  // namespace
}  // namespace weavefront::test
