#include "weavefront/solver/step_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "small_scene.hpp"
#include "weavefront/solver/contact_modes.hpp"
#include "weavefront/solver/coupling_on_edges.hpp"
#include "weavefront/solver/flat_contact.hpp"
#include "weavefront/solver/tight_step_bound.hpp"
#include "weavefront/state/values.hpp"

namespace weavefront::solver::test {

namespace {

using Matrix8 = std::array<std::array<double, 8>, 8>;

/// By powers of the matrix, moved so far that none of its eigenvalues is negative.
double largest_eigenvalue(const Matrix8& K, double shift) {
    std::array<double, 8> v{};
    for (std::size_t i = 0; i < 8; ++i) v[i] = std::sin(1.0 + 7.0 * static_cast<double>(i));
    double value = 0;
    for (int k = 0; k < 20000; ++k) {
        std::array<double, 8> w{};
        double along = 0, length = 0, before = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            w[i] = shift * v[i];
            for (std::size_t j = 0; j < 8; ++j) w[i] += K[i][j] * v[j];
            along += w[i] * v[i], length += w[i] * w[i], before += v[i] * v[i];
        }
        value = along / before - shift;
        for (std::size_t i = 0; i < 8; ++i) v[i] = w[i] / std::sqrt(length);
    }
    return value;
}

/// Largest eigenvalue of an element of omega^2 `inside` in all uniform modes, with c u_i x u_j on some of its
/// edges: 4 c over its mass is `coupling`, the unknowns are x and y of the four corners. Of the corners'
/// values the gradients see the differences of opposite ones.
double with_free_edges(double inside, double coupling,
                       const std::vector<std::pair<std::size_t, std::size_t>>& edges) {
    Matrix8 K{};
    for (std::size_t i = 0; i < 8; ++i) K[i][i] = inside / 2, K[i][i ^ 2] = -inside / 2;
    for (const auto& [i, j] : edges) {
        K[i][4 + j] += coupling / 2, K[4 + j][i] += coupling / 2;
        K[4 + i][j] -= coupling / 2, K[j][4 + i] -= coupling / 2;
    }
    return largest_eigenvalue(K, 2 * coupling);
}

}  // namespace

TEST(JointFrequency, IsTheEigenvalueOfAlongAndAcross) {
    for (const double in_plane : {0.2, 1.0, 3.0})
        for (const double out_of_plane : {0.0, 0.1, 0.5})
            for (const double angle : {0.0, 0.3, 1.0, 1.5707963267948966}) {
                const double contact = 1.3, s = std::sin(angle), c = std::cos(angle);
                const double a = in_plane + contact * s * s, b = out_of_plane + contact * c * c;
                const double exact = (a + b) / 2 + std::hypot((a - b) / 2, contact * s * c);
                const double bound = joint_frequency_squared(in_plane, out_of_plane, contact, s * s);
                if (in_plane > out_of_plane) {
                    EXPECT_NEAR(bound, exact, 1e-14 * exact)
                        << in_plane << " " << out_of_plane << " " << angle;
                    const double back = in_plane_of_joint(bound, out_of_plane, contact, s * s);
                    EXPECT_NEAR(bound > out_of_plane + contact * (1 + 1e-9) ? back : in_plane, in_plane, 1e-9)
                        << out_of_plane << " " << angle;
                } else {
                    EXPECT_GE(bound, exact * (1 - 1e-14));  // the angle may also be less
                }
            }
}

// v' = v - dt (K x + C v), x' = x + dt v' has the eigenvalue -1 where K dt^2 + 2 C dt = 4: K + C omega =
// omega^2 with omega = 2/dt.
TEST(DampedFrequency, IsTheStabilityLimitOfCentralDifferences) {
    for (const double damping : {0.0, 0.1, 1.0, 5.0}) {
        const ContactModes contact{.stiffness = 1.3, .damping = damping};
        const double one_direction = damped_frequency_squared(0.7, 0.2, contact, 1);
        EXPECT_NEAR(0.7 + 1.3 + damping * std::sqrt(one_direction), one_direction, 1e-3 * one_direction)
            << damping;
        EXPECT_GE(one_direction, (0.7 + 1.3 + damping * std::sqrt(one_direction)) * (1 - 1e-14)) << damping;
        const double at_right_angles = damped_frequency_squared(0.7, 0.2, contact, 0);
        EXPECT_NEAR(0.2 + 1.3 + damping * std::sqrt(at_right_angles), at_right_angles, 1e-3 * at_right_angles)
            << damping;
        EXPECT_NEAR(damped_frequency_squared(4.7e3, 0.2, contact, 0), 4.7e3, 1e-9)
            << damping;  // the fabric's own
    }
}

// A free stack of plies with a spring u k and a damper 2 xi sqrt(k m/2) between each two: both matrices have
// the mode of alternating signs.
TEST(DampedFrequency, CountsTheHighestModeOfAStack) {
    for (const int plies : {2, 3, 8}) {
        const auto scene = scene_with(
            {"projectile=", "contact={plies: {stiffness: 1e13 N/m^3, unloading: 10, damping: 0.2}}",
             "target.plies.count=" + std::to_string(plies)});
        double stretched = 0, moved = 0;
        for (int i = 0; i < plies; ++i) {
            const auto at = [&](int ply) {
                return (ply % 2 == 0 ? 1 : -1) * std::sin(std::numbers::pi * (2 * ply + 1) / (2 * plies));
            };
            moved += at(i) * at(i);
            if (i + 1 < plies) stretched += std::pow(at(i + 1) - at(i), 2);
        }
        const double m = 0.204, k = 1e13, springs = stretched / moved;
        const auto modes = contact_modes(scene);
        EXPECT_NEAR(modes.stiffness, springs * 10 * k / m, 1e-12 * modes.stiffness) << plies;
        EXPECT_NEAR(modes.damping, springs * 2 * 0.2 * std::sqrt(k * m / 2) / m, 1e-12 * modes.damping)
            << plies;
    }
}

TEST(FreeEdges, AddTheEigenvalueOfWhatIsLeftOnThem) {
    for (const double inside : {0.0, 0.1, 1.0, 20.0})
        for (const double coupling : {0.05, 1.0, 3.0}) {
            const double edge = with_free_edges(inside, coupling, {{0, 1}}),
                         corner = with_free_edges(inside, coupling, {{3, 0}, {0, 1}});
            EXPECT_NEAR(inside + excess_on_edge(inside, coupling), edge,
                        1e-9 * edge);  // the power iteration's
            const double bound = inside + excess_at_corner(inside, coupling);
            EXPECT_GE(bound, corner * (1 - 1e-9)) << inside << " " << coupling;
            EXPECT_LE(bound, corner + 1e-3 * coupling)
                << inside << " " << coupling;  // six steps of a contraction by a sixth at the least
        }
}

TEST(TightStepBound, IsOffUnlessItsPremisesHold) {
    const std::vector<std::string> straight_alone{"projectile=", "contact=", "fabrics.kevlar129.thickness=0",
                                                  "fabrics.kevlar129.friction=0",
                                                  "fabrics.kevlar129.lateral="};
    EXPECT_FALSE(TightStepBound::applies_to(scene_with(straight_alone)));
    EXPECT_FALSE(TightStepBound::applies_to(
        scene_with({"projectile=", "contact=", "fabrics.kevlar129.formulation=paper"})));
    EXPECT_TRUE(TightStepBound::applies_to(scene_with({"projectile=", "contact="})));  // crimp and packing
    EXPECT_TRUE(TightStepBound::applies_to(scene_with({"fabrics.kevlar129.formulation=paper"})));  // contact
}

/// Flat fabric without coupling has the bound max(in_plane, out_of_plane + contact). Where contact is weak,
/// the bound with coupling and contact in any direction is lower: that of the fabric alone plus contact.
TEST(TightStepBound, CouplesFlatFabricInWeakContact) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const std::vector<std::string> in_contact{
        "projectile=", "contact={plies: {stiffness: 6e11 N/m^3, unloading: 1, damping: 0}}",
        "fabrics.kevlar129.thickness=0.82 mm", "target.plies.count=2"};
    auto alone = in_contact;
    alone[1] = "contact=";
    const auto bound = [&](const std::vector<std::string>& overrides) {
        const auto scene = scene_with(overrides);
        Simulation simulation(scene, comm);
        return StepBound(scene, simulation.panel()).frequency_squared(simulation.model(), {}, comm);
    };
    const double fabric = bound(alone), contact = contact_modes(scene_with(in_contact)).stiffness;
    EXPECT_GT(contact, 0.1 * fabric);
    constexpr double in_steps = 2.0 / 512;  // of the bound, and of the search for the best coupling
    EXPECT_LE(bound(in_contact), (fabric + contact) * (1 + 2 * in_steps));
}

/// A ply folded along x = 0: its halves lean by an angle, and its corners stay at one height.
TEST(FlatContact, SeesTwiceTheLeanOfTheSteepestElement) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    for (const double lean : {0.0, 0.1, -0.3, 0.9}) {
        Simulation simulation(scene_with({"projectile=", "contact="}), comm);
        set_motion(
            simulation,
            [&](const Vec3& x) {
                return Vec3(x.x() * std::cos(lean), x.y(), std::abs(x.x()) * std::sin(lean));
            },
            [](const Vec3&) { return Vec3(Vec3::Zero()); });
        FlatContact contact(simulation.panel());
        const Vec3 axis = contact.axis(simulation.model(), comm);
        EXPECT_NEAR(axis.z(), 1, 1e-15) << lean;
        const double beyond_45_degrees = 1, expected = std::abs(lean) > std::numbers::pi / 4
                                                           ? beyond_45_degrees
                                                           : std::pow(std::sin(2 * lean), 2);
        EXPECT_NEAR(contact.sine_squared(simulation.model(), axis, {}, comm), expected, 1e-13) << lean;
    }
}

/// Pulls the fill of slack fabric straight within 20 steps, where |y| is at least `from`. Between two checks
/// a step may be longer than the present state allows by half of what the safety factor leaves.
void straighten(const std::string& mesh, double from) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene =
        scene_with({"projectile=", "contact=", "fabrics.kevlar129.thickness=0.82 mm",
                    "fabrics.kevlar129.lateral=", "fabrics.kevlar129.friction=", "target.mesh=" + mesh,
                    "target.edges={x: free, y: fixed}", "time.safety=0.9"});
    Simulation simulation(scene, comm);
    const double rate = 2e4;  // 1/s
    set_motion(
        simulation, [](const Vec3& x) { return x; },
        [&](const Vec3& x) {
            return std::abs(x.y()) < from ? Vec3(Vec3::Zero()) : Vec3(rate * x.x(), 0, 0);
        });
    const double longest = simulation.time_step();
    double shortest = longest;
    for (int n = 0; n < 60; ++n) {
        simulation.advance_forces();
        const double fresh =
            StepBound(scene, simulation.panel()).frequency_squared(simulation.model(), {}, comm);
        const double allowed = scene.time.safety * 2 / std::sqrt(fresh);
        EXPECT_LE(simulation.time_step(), allowed * 1.05) << n;
        shortest = std::min(shortest, simulation.time_step());
        simulation.integrate();
    }
    EXPECT_LT(shortest, 0.75 * longest);  // they were slack, and became straight
}

TEST(StepBound, ShortensTheStepBeforeSlackYarnsAreStraight) { straighten("{center: 2 mm}", 0); }

// The elements that straighten are as short as the square ones along the fill, and three times as long along
// the warp.
TEST(StepBound, ShortensTheStepWhereOnlyOblongElementsStraighten) {
    straighten("{center: 1 mm, edge: 3 mm, growth: 1.6}", 3e-3);
}

/// Stretches fill and warp by `strain` and turns both by `turn` towards each other.
void deform(Simulation& simulation, const std::vector<Vec3>& at_rest, double strain, double turn) {
    auto& model = simulation.model();
    const double c = (1 + strain) * std::cos(turn), s = (1 + strain) * std::sin(turn);
    for (std::size_t n = 0; n < at_rest.size(); ++n) {
        const Vec3& X = at_rest[n];
        model.nodes.x[n] = Vec3(c * X.x() + s * X.y(), s * X.x() + c * X.y(), X.z());
    }
    for (const auto& group : model.groups) {
        shell::AlignedVector<double> forces(static_cast<std::size_t>(group->packs()) *
                                            shell::forces_per_pack);
        shell::Events events;
        group->advance(0, group->packs(), model.nodes.x, forces, events);
    }
}

/// The bound that goes on from the state of another.
StepBound restored(StepBound& from, const scene::Scene& scene, const mesh::Panel& panel,
                   const parallel::Communicator& comm) {
    state::Values values;
    state::ValueWriter writer(values, comm);
    from.state(writer);
    StepBound bound(scene, panel);
    state::ValueReader reader(values, comm);
    bound.state(reader);
    return bound;
}

/// Fabric that is slack and taut in turn: bounds rise, fall, and are sought in vain. A bound that was saved
/// after any call must give the same answers from then on, and have the same elements monitored.
TEST(SavedState, HoldsAllThatTheStepBoundRemembers) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with({"projectile=", "contact=", "fabrics.kevlar129.thickness=0.82 mm"});
    Simulation simulation(scene, comm);
    auto& model = simulation.model();
    const std::vector<Vec3> at_rest(model.nodes.x.begin(), model.nodes.x.end());
    StepBound whole(scene, simulation.panel());
    const auto has_stiffened = [&](const StepBound& bound, double strain, double turn) {
        bound.set_triggers(model);
        deform(simulation, at_rest, strain, turn);
        return std::ranges::any_of(model.groups, [](const auto& group) { return group->has_stiffened(); });
    };
    std::vector<StepBound> others;
    for (int round = 0; round < 3; ++round)
        for (const double strain : {0.0,  0.02, 0.04, 0.06, 0.05, 0.03, 0.0,  0.0,  0.06, 0.0, 0.04,
                                    0.04, 0.12, 0.12, 0.12, 0.12, 0.12, 0.12, 0.12, 0.12, 0.12}) {
            deform(simulation, at_rest, strain, 0);
            const double bound = whole.frequency_squared(model, {}, comm);
            for (auto& other : others) ASSERT_EQ(other.frequency_squared(model, {}, comm), bound);
            others.push_back(restored(whole, scene, simulation.panel(), comm));
            EXPECT_EQ(others.back().steps_to_next(), whole.steps_to_next());
            constexpr double packed = 0.2;  // rad, beyond the locking angle
            for (const auto& [more, turn] : {std::pair(0.0, 0.0), {0.002, 0.0}, {0.02, 0.0}, {0.0, packed}})
                EXPECT_EQ(has_stiffened(others.back(), strain + more, turn),
                          has_stiffened(whole, strain + more, turn))
                    << strain << ' ' << more << ' ' << turn;
        }
}

}  // namespace weavefront::solver::test
