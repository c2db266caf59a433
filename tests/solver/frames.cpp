#include "frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "small_scene.hpp"
#include "weavefront/solver/guard.hpp"
#include "weavefront/state/record.hpp"

namespace weavefront::solver::test {
namespace {

using scene::Field;

const io::Array& array(const io::Frame& frame, const std::string& name) {
    for (const auto* arrays : {&frame.point_data, &frame.cell_data})
        for (const auto& candidate : *arrays)
            if (candidate.name == name) return candidate;
    throw std::logic_error("the frame has no " + name);
}

io::Frame frame_of(Simulation& simulation, const std::vector<Field>& fields) {
    app::ProjectileSurfaces surfaces;
    surfaces.all.points = {{0, 0, 0}, {1e-3, 0, -2e-3}};
    surfaces.points = {2};
    surfaces.quads = {0};
    return app::frame_of(simulation, surfaces, fields);
}

/// Velocities of the owned nodes in a frame now.
std::vector<Vec3> velocities_of(Simulation& simulation) {
    const auto values = array(frame_of(simulation, {Field::velocity}), "velocity").values;
    std::vector<Vec3> velocities;
    for (std::size_t i = 0; i < values.size(); i += 3)
        velocities.emplace_back(values[i], values[i + 1], values[i + 2]);
    return velocities;
}

template <class Term>
double sum_over_owned(const Simulation& simulation, const parallel::Communicator& comm,
                      const std::vector<Vec3>& velocities, Term term) {
    const auto& nodes = simulation.model().nodes;
    double sum = 0;
    for (std::size_t n = 0, i = 0; n < static_cast<std::size_t>(nodes.count); ++n)
        if (nodes.owned[n]) sum += term(nodes.mass[n], nodes.v[n], velocities[i++]);
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, comm.get());
    return sum;
}

class Frames : public testing::Test {
  protected:
    const parallel::Communicator comm_{MPI_COMM_WORLD};
};

// The scheme's own velocities stand half a step behind: in a frame the motion before and after it are weighed
// by the other's time.
TEST_F(Frames, HaveTheVelocitiesOfTheirTime) {
    Simulation simulation(scene_with({"target.plies.count=2"}), comm_);
    advance(simulation, 40);
    simulation.advance_forces();
    const auto before = simulation.model().nodes.v;
    const auto shown = velocities_of(simulation);
    const Vec3 of_projectile = simulation.projectile_velocity(0),
               behind = simulation.model().projectiles.front().body.velocity();
    const double last = simulation.time();
    simulation.integrate();
    const auto& nodes = simulation.model().nodes;
    const double next_step = simulation.time() - last,
                 last_step = simulation.time_step();  // which did not change here
    ASSERT_NEAR(next_step, last_step, 1e-6 * last_step);
    for (std::size_t n = 0, i = 0; n < static_cast<std::size_t>(nodes.count); ++n) {
        if (!nodes.owned[n]) continue;
        const Vec3 expected = (before[n] + nodes.v[n]) / 2;
        EXPECT_LT((shown[i++] - expected).norm(), 1e-9) << n;  // m/s; the times above are rounded
    }
    EXPECT_LT((of_projectile - (behind + simulation.model().projectiles.front().body.velocity()) / 2).norm(),
              1e-9);
    EXPECT_GT((of_projectile - behind).norm(), 1e-6);
}

// The ledger takes v(n-1/2).v(n+1/2), which is what the scheme keeps. It is less than v(n)^2 by the square of
// half the change of a step.
TEST_F(Frames, HaveTheKineticEnergyOfTheHistory) {
    Simulation simulation(scene_with({"target.plies.count=2", "damping=1000 1/s"}), comm_);
    advance(simulation, 40);
    simulation.advance_forces();
    const auto shown = velocities_of(simulation);
    const auto balance = simulation.balance();
    const double of_change = sum_over_owned(
        simulation, comm_, shown, [](double mass, const Vec3& half_step_behind, const Vec3& now) {
            return mass * (now.squaredNorm() - (now - half_step_behind).squaredNorm()) / 2;
        });
    ASSERT_GT(balance.kinetic_fabric, 0.01);
    constexpr double rounding =
        400 * 10 * 0x1p-44;  // each of some hundred nodes to 2^-44 of the initial 10 J
    EXPECT_NEAR(of_change, balance.kinetic_fabric, rounding);
    const double kinetic = sum_over_owned(
        simulation, comm_, shown,
        [](double mass, const Vec3&, const Vec3& now) { return mass * now.squaredNorm() / 2; });
    EXPECT_NEAR(kinetic, balance.kinetic_fabric, 0.01 * balance.kinetic_fabric);

    const auto frame = frame_of(simulation, {Field::velocity});
    const auto& surface = array(frame, "velocity").projectile;
    const auto& projectile = simulation.model().projectiles.front().body;
    const body::Motion motion{projectile.centre(), balance.projectiles[0].velocity,
                              simulation.projectile_angular_velocity(0)};
    const Vec3 second = motion.at(projectile.to_space({1e-3, 0, -2e-3}));
    ASSERT_EQ(surface.size(), 6U);
    for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(surface[3 + d], second[static_cast<Eigen::Index>(d)], 1e-12);
}

// Nodes of an eroded element fly apart.
TEST_F(Frames, HoldWhatErodedElementsShow) {
    const std::vector<Field> fields{Field::strain, Field::stress, Field::braid_angle, Field::crimp,
                                    Field::broken};
    Simulation simulation(scene_with({"fabrics.kevlar129.failure={static_strain: 1 %, hooke_strain: 1 %}",
                                      "target.edges={x: fixed, y: fixed}", "projectile.velocity.2=600 m/s"}),
                          comm_);
    io::Frame first;
    std::int64_t eroded = 0;
    for (int step = 0; step < 2000 && eroded < 4; ++step) {
        simulation.advance_forces();
        first = frame_of(simulation, fields);
        std::array<std::int64_t, 1> count{std::ranges::count(first.eroded, true)};
        comm_.sum(count);
        eroded = count[0];
        simulation.integrate();
    }
    ASSERT_GE(eroded, 4);
    // Columns change ranks on the way, with what they show.
    partition::Decomposition turned{comm_.size(), {}};
    for (std::int64_t c = 0; c < simulation.panel().columns(); ++c)
        turned.owner.push_back(static_cast<std::int32_t>(c % comm_.size()));
    const auto ids = simulation.model().global.element_ids;
    const auto strain_of = [&](const io::Frame& frame, const std::vector<std::int64_t>& elements) {
        std::vector<double> strains(static_cast<std::size_t>(simulation.panel().elements()), 0);
        for (std::size_t e = 0; e < elements.size(); ++e)
            if (frame.eroded[e])
                for (const auto& cells : frame.cell_data)
                    strains[static_cast<std::size_t>(elements[e])] += cells.values[e];
        MPI_Allreduce(MPI_IN_PLACE, strains.data(), static_cast<int>(strains.size()), MPI_DOUBLE, MPI_SUM,
                      comm_.get());
        return strains;
    };
    const auto at_first = strain_of(first, ids);
    simulation.redistribute(turned);
    advance(simulation, 30);
    simulation.advance_forces();
    const auto later = strain_of(frame_of(simulation, fields), simulation.model().global.element_ids);
    for (std::size_t e = 0; e < at_first.size(); ++e)
        if (at_first[e] != 0) {
            EXPECT_EQ(later[e], at_first[e]) << e;
        }
}

TEST_F(Frames, KeepWhatIsNotFinite) {
    Simulation simulation(scene_with({}), comm_);
    simulation.advance_forces();
    simulation.model().nodes.x[0].y() = std::numeric_limits<double>::quiet_NaN();
    const auto frame = frame_of(simulation, {});
    EXPECT_TRUE(!simulation.model().nodes.owned[0] || std::isnan(frame.points[1]));
}

// Of a force that is not finite nothing is shown.
TEST_F(Frames, ShowTheStateBeforeAForceThatIsNotFinite) {
    Simulation simulation(scene_with({}), comm_);
    advance(simulation, 40);
    auto& group = *simulation.model().groups[0];
    std::vector<double> record;
    state::RecordWriter writer(record);
    group.state(writer, 0);
    for (auto& value : record) value = std::numeric_limits<double>::quiet_NaN();
    state::RecordReader reader(record);
    group.state(reader, 0);
    EXPECT_THROW(simulation.advance_forces(), GuardStop);
    const auto& nodes = simulation.model().nodes;
    const auto shown = velocities_of(simulation);
    for (std::size_t n = 0, i = 0; n < static_cast<std::size_t>(nodes.count); ++n)
        if (nodes.owned[n]) {
            EXPECT_EQ(shown[i++], nodes.v[n]);
        }
    EXPECT_EQ(simulation.projectile_velocity(0), simulation.model().projectiles.front().body.velocity());
}

// Any rank may ask, all stop after the same step, and nothing else changes.
TEST_F(Frames, AreTheLastOnesWhereARankAsksToStop) {
    Simulation simulation(scene_with({}), comm_), other(scene_with({}), comm_);
    advance(simulation, 5);
    advance(other, 5);
    EXPECT_FALSE(simulation.is_stop_agreed());
    if (comm_.rank() == comm_.size() - 1) simulation.request_stop();
    EXPECT_FALSE(simulation.is_stop_agreed());
    simulation.advance_forces();
    other.advance_forces();
    EXPECT_TRUE(simulation.is_stop_agreed());
    EXPECT_EQ(simulation.balance().kinetic_fabric, other.balance().kinetic_fabric);
}

}  // namespace
}  // namespace weavefront::solver::test
