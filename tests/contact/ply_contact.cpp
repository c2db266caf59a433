/// Plies response together.

#include "weavefront/contact/ply_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "surfaces.hpp"
#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/state/record.hpp"

namespace weavefront::test {
namespace {

using contact::PlyContact;

constexpr double k = 1e13, side = 10e-3, thickness = 0.14e-3, gap = 0.2e-3;
const scene::ContactLaw elastic{.stiffness = k, .unloading = 1, .damping = 0};

contact::PlyProperties ply_at(double z) { return {.z = z, .thickness = thickness, .areal_density = 0.2}; }

/// Moves ply 0 by `travel` in equal steps; returns the forces at the end. @param skin of the search, m
std::vector<contact::PairForce> press(PlyContact& contact, Plies& plies, std::size_t moving,
                                      const Vec3& travel, double skin = 1e-3) {
    constexpr int steps = 20;
    const double dt = 1e-7;
    Positions v(plies.x.size(), Vec3::Zero());
    for (std::size_t n = 0; n < moving; ++n) v[n] = travel / (steps * dt);
    contact::ContactForces forces;
    contact.update_candidates(plies.surface, contact::SweptBounds(plies.x), plies.x, skin);
    for (int step = 0; step < steps; ++step) {
        for (std::size_t n = 0; n < moving; ++n) plies.x[n] += dt * v[n];
        forces.clear();
        contact.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, dt, 1, forces);
    }
    return forces.pairs;
}

TEST(PlyContact, FlatPliesPushEachOtherByStiffnessOverlapAndArea) {
    for (const std::optional<double> spacing : {std::optional<double>(), std::optional(0.25e-3)}) {
        Plies plies;
        plies.add(8, ply_at(0), flat(side, 0));
        plies.add(11, ply_at(gap), flat(1.1 * side, gap));  // facets of the two do not lie over each other
        PlyContact contact(elastic, spacing, plies.surface, plies.x);
        const double overlap = 0.01e-3, pressure = k * overlap;
        EXPECT_TRUE(press(contact, plies, 81, {0, 0, gap - thickness - 1e-9}).empty()) << "not yet touching";
        const auto sum = assemble(press(contact, plies, 81, {0, 0, 1e-9 + overlap}), plies.x);
        const double force = pressure * side * side;
        EXPECT_NEAR(sum.on_slaves.z() / -force, 1, 1e-10);
        EXPECT_LT(sum.on_slaves.head<2>().norm(), 1e-14 * force);
        EXPECT_LT(sum.net.norm(), 1e-14 * force);
        EXPECT_LT(sum.moment.norm(), 1e-14 * force * side);
        // an inner node bears a facet's area, a corner a quarter
        EXPECT_NEAR(sum.nodal[40].z() / -(force / 64), 1, 1e-10);
        EXPECT_NEAR(sum.nodal[0].z() / -(force / 256), 1, 1e-10);
    }
}

TEST(PlyContact, BumpyPliesKeepMomentumAndAngularMomentum) {
    std::mt19937_64 random(11);
    Plies plies;
    const auto bumpy = [&](double size, double z) {
        return [&random, size, z](double u, double v) {
            return Vec3(size * (u - 0.5), size * (v - 0.5),
                        z + 0.3e-3 * std::sin(4 * u) * v + uniform(random, -0.02e-3, 0.02e-3));
        };
    };
    plies.add(8, ply_at(0), bumpy(side, 0));
    plies.add(11, ply_at(gap), bumpy(1.1 * side, gap));
    PlyContact contact({.stiffness = k, .unloading = 10, .damping = 0.2}, 0.25e-3, plies.surface, plies.x);
    const auto forces = press(contact, plies, 81, {0.05e-3, 0.02e-3, 0.15e-3});
    ASSERT_GT(forces.size(), 50U);
    const auto sum = assemble(forces, plies.x);
    EXPECT_LT(sum.net.norm(), 1e-13 * sum.on_slaves.norm());
    EXPECT_LT(sum.moment.norm(),
              1e-9 * sum.on_slaves.norm() * side);  // the lines are found to 1e-10 of a facet
    for (const auto& pair : forces) {
        Vec3 slave = Vec3::Zero(), master = Vec3::Zero();
        for (std::size_t a = 0; a < 4; ++a) slave += pair.on_slave[a], master += pair.on_master[a];
        ASSERT_LT((slave - pair.total).norm() + (master + pair.total).norm(), 1e-13 * pair.total.norm());
    }
}

TEST(PlyContact, MeetsThePlyBehindThroughAHole) {
    Plies plies;
    plies.add(8, ply_at(0), flat(side, 0));
    plies.add(8, ply_at(gap), flat(side, gap));
    plies.add(8, ply_at(2 * gap), flat(side, 2 * gap));
    plies.erode([](std::size_t f) { return f >= 64 && f < 128; });  // ply 1 is gone
    PlyContact contact(elastic, 0.5e-3, plies.surface, plies.x);
    const double overlap = 0.01e-3;
    const auto forces = press(contact, plies, 81, {0, 0, 2 * gap - thickness + overlap});
    for (const auto& pair : forces)
        for (const auto node : pair.master) ASSERT_GE(node, 162);
    EXPECT_NEAR(assemble(forces, plies.x).on_slaves.z() / -(k * overlap * side * side), 1, 1e-9);
}

// The ply between has flown ahead; it lets see what is behind near the rim of its hole only, not wherever a
// search with a wide reach has found a rim.
TEST(PlyContact, APlyHidesThePliesBehindItExceptAtItsFreeEdges) {
    Plies plies;
    plies.add(8, ply_at(0), flat(side, 0));
    plies.add(8, ply_at(gap), flat(side, 5e-3));
    plies.add(8, ply_at(2 * gap), flat(side, 2 * gap));
    plies.erode([](std::size_t f) { return f == 64; });
    PlyContact contact(elastic, 0.5e-3, plies.surface, plies.x);
    std::vector<bool> response(64, false);
    for (const auto& pair : press(contact, plies, 81, {0, 0, 2 * gap - thickness + 0.01e-3}, side))
        response[static_cast<std::size_t>(pair.slave[0] / 9 * 8 + pair.slave[0] % 9)] = true;
    for (std::size_t f = 0; f < 64; ++f) EXPECT_EQ(response[f], f % 8 <= 2 && f / 8 <= 2) << f;
}

/// Two plies that shear, turn and approach each other while their nodes chatter: some of it in a pass, by
/// chance.
struct Motion {
    Motion(std::mt19937_64& chance, const Positions& start, std::size_t of_first)
        : random(chance), X(start), first(of_first) {
        const auto some = [&](double most) { return random() % 2 == 0 ? 0 : uniform(random, -most, most); };
        spin = {some(2e3), some(2e3), some(3e3)};
        approach = uniform(random, 20, 60), bulge = some(60), common = some(200), shear = some(3e3),
        turn = some(1e3), chatter = some(20e-6);
    }

    /// Positions at a time, s.
    Positions at(double t) {
        const Eigen::AngleAxisd turned(t * spin.norm(),
                                       spin.norm() > 0 ? Vec3(spin.normalized()) : Vec3::UnitZ());
        Positions x = X;
        for (std::size_t n = 0; n < x.size(); ++n) {
            const double forth_and_back =
                20e-6 - std::abs(approach * t - 80e-6) + 60e-6;  // it presses and lets go
            if (n < first) {
                const double hump = std::exp(-X[n].squaredNorm() / 4e-6);
                x[n] +=
                    Vec3(shear * t * X[n].y(), 0, forth_and_back + bulge * t * hump + turn * t * X[n].x());
            }
            x[n] = turned * x[n] + Vec3(0, 0, common * t);
            if (chatter != 0 && t > 0)
                x[n] +=
                    chatter * Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        }
        return x;
    }

    std::mt19937_64& random;
    Positions X;
    std::size_t first;
    Vec3 spin;
    double approach, bulge, common, shear, turn, chatter;
};

bool same_bits(const std::vector<contact::PairForce>& one, const std::vector<contact::PairForce>& other) {
    return std::ranges::equal(one, other, [](const auto& a, const auto& b) {
        return a.slave == b.slave && a.master == b.master && a.on_slave == b.on_slave &&
               a.on_master == b.on_master && a.total == b.total;
    });
}

/// By facet, so that they compare whatever the order.
void sort(std::vector<contact::PairForce>& forces) {
    std::ranges::stable_sort(forces, [](const auto& a, const auto& b) {
        return std::tie(a.slave, a.master) < std::tie(b.slave, b.master);
    });
}

// Facets wait until others may have come near. A contact made anew in every step, with the memory of the
// last, has waited for nothing.
TEST(PlyContact, CullingChangesNoBit) {
    constexpr double dt = 1e-7, skin = 1.5e-3;
    const scene::ContactLaw law{.stiffness = k, .unloading = 10, .damping = 0.2};
    std::mt19937_64 random(17);
    for (int pass = 0; pass < 24; ++pass) {
        Plies plies;
        plies.add(12, ply_at(0), flat(side, 0));
        plies.add(10, ply_at(gap),
                  [&](double u, double v) { return flat(side, gap + uniform(random, 0, 0.02e-3))(u, v); });
        Motion motion(random, plies.x, 13 * 13);
        PlyContact waiting(law, 0.25e-3, plies.surface, plies.x);
        auto anew = waiting;
        waiting.update_candidates(plies.surface, contact::SweptBounds(plies.x), plies.x, skin);
        std::size_t touched = 0, ignore = 0;
        for (int step = 1; step <= 60; ++step) {
            auto x = motion.at(step * dt);
            Positions v(x.size());
            for (std::size_t n = 0; n < x.size(); ++n) v[n] = (x[n] - plies.x[n]) / dt;
            plies.x = std::move(x);
            contact::ContactForces of_waiting, of_anew;
            waiting.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, dt, 0.7, of_waiting);
            PlyContact next(law, 0.25e-3, plies.surface, motion.X);
            for (std::int32_t f = 0; f < plies.surface.owned; ++f) {
                std::vector<double> record;
                state::RecordWriter writer(record);
                anew.state(writer, f);
                state::RecordReader reader(record);
                next.state(reader, f);
            }
            anew = std::move(next);
            anew.update_candidates(plies.surface, contact::SweptBounds(plies.x), plies.x, skin);
            anew.evaluate(plies.surface, plies.fresh_normals(), plies.x, v, dt, 0.7, of_anew);
            auto &forces = of_waiting.pairs, &swept = of_anew.pairs;
            sort(forces), sort(swept);
            ASSERT_TRUE(same_bits(forces, swept)) << "pass " << pass << ", step " << step;
            touched = std::max(touched, swept.size()), ignore += swept.size() < touched;
        }
        EXPECT_GT(touched, 0U) << pass;
        EXPECT_GT(ignore, 0U) << pass;
    }
}

TEST(PlyContact, ForgetsContactWhenPliesPartInOneStep) {
    Plies plies;
    plies.add(4, ply_at(0), flat(side, 0));
    plies.add(4, ply_at(gap), flat(side, gap));
    PlyContact contact(elastic, 0.5e-3, plies.surface, plies.x);
    press(contact, plies, 25, {0, 0, gap - thickness + 0.01e-3});
    EXPECT_TRUE(contact.touches(5));
    press(contact, plies, 25, {0, 0, -1e-3});
    EXPECT_FALSE(contact.touches(5));
}

TEST(PlyContact, PliesThatTouchAtTheStartPushWhenTheyHaveComeNearerByTheSlack) {
    for (const double distance : {thickness, thickness / 2}) {  // touching, and closer than their thickness
        const double slack = contact::ContactDistances::slack * distance;
        Plies plies;
        plies.add(4, ply_at(0), flat(side, 0));
        plies.add(4, ply_at(distance), flat(side, distance));
        PlyContact contact(elastic, 0.5e-3, plies.surface, plies.x);
        EXPECT_TRUE(press(contact, plies, 25, {0, 0, slack - 1e-9}).empty());
        const auto sum = assemble(press(contact, plies, 25, {0, 0, 0.01e-3 + 1e-9}), plies.x);
        EXPECT_NEAR(sum.on_slaves.z() / -(k * 0.01e-3 * side * side), 1, 1e-9);
    }
}

}  // namespace
}  // namespace weavefront::test
