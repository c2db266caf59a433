/// Columns that change ranks while a projectile perforates them.

#include "weavefront/solver/redistribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "element_state.hpp"
#include "small_scene.hpp"
#include "weavefront/state/table.hpp"

namespace weavefront::solver::test {
namespace {

/// Two plies on a frame that are perforated: every kind of memory that an element can have.
const std::vector<std::string> perforated{
    "target.plies.count=2", "fabrics.kevlar129.failure={static_strain: 3.3 %, hooke_strain: 2.7 %}",
    "target.edges={y: frame}", "target.frame={opening: {y: 16 mm}}", "projectile.velocity=[0, 0, 600 m/s]"};

/// A projectile that comes down on the frame.
const std::vector<std::string> onto_the_frame{
    "target.size=[30 mm, 30 mm]", "target.edges={y: frame}", "target.frame={opening: {y: 8 mm}}",
    "projectile.position=[0, 3.5 mm, -0.2 mm]", "projectile.velocity=[0, 0, 100 m/s]"};

/// The first with friction in all of them, of points that stick and slip.
const std::vector<std::string> with_friction = [] {
    auto overrides = perforated;
    for (const auto* friction : {"contact.projectile.friction={static: 0.3, kinetic: 0.2}",
                                 "contact.plies.friction=0.2", "contact.frame.friction=0.1"})
        overrides.emplace_back(friction);
    return overrides;
}();

/// Two plies that slip between the jaws of a round clamp.
const std::vector<std::string> clamped{"target.plies.count=2", "target.mesh.center=1 mm",
                                       "target.frame={opening: {diameter: 16 mm}}",
                                       "target.edges={x: {clamp: {pressure: 2 MPa, friction: 0.2}}, y: "
                                       "{clamp: {pressure: 2 MPa, friction: 0.2}}}"};

/// A projectile that comes down on the frame and rubs on it.
const std::vector<std::string> onto_the_frame_with_friction = [] {
    auto overrides = onto_the_frame;
    overrides.emplace_back("contact.projectile.friction={static: 0.3, kinetic: 0.2}");
    return overrides;
}();

/// A slack ply that does not break: its yarns, straightened and packed here and there, decide on the time
/// step.
const std::vector<std::string> slack{"target.size=[22 mm, 22 mm]", "fabrics.kevlar129.thickness=0.82 mm",
                                     "projectile.velocity=[0, 0, 150 m/s]",
                                     "contact.projectile={stiffness: 1e12 N/m^3, unloading: 2}"};

/// Two that perforate, one after the other.
const std::vector<std::string> two_projectiles = [] {
    auto overrides = perforated;
    overrides.insert(
        overrides.end(),
        {"contact.projectile.friction=0.2", "projectile=",
         "projectiles=[{shape: sphere, diameter: 6 mm, mass: 0.5 g, position: [-5 mm, 0, -0.2 mm], "
         "velocity: [0, 0, 600 m/s]}, {shape: box, size: [4 mm, 3 mm, 5 mm], mass: 0.4 g, "
         "position: [5 mm, 2 mm, -2 mm], velocity: [0, 0, 700 m/s], delay: 2 us, "
         "angular_velocity: [2e4 rad/s, 0, 0]}]"});
    return overrides;
}();

/// Owners that change from one round to the next without any order.
partition::Decomposition scattered(const mesh::Panel& panel, int ranks, std::int64_t round) {
    partition::Decomposition decomposition{ranks, {}};
    for (std::int64_t c = 0; c < panel.columns(); ++c)
        decomposition.owner.push_back(
            static_cast<std::int32_t>((c * 7 + c / panel.columns_x() * 3 + round) % ranks));
    return decomposition;
}

void expect_same_projectiles(const Balance& a, const Balance& b, int step) {
    for (std::size_t p = 0; p < a.projectiles.size(); ++p) {
        ASSERT_EQ(a.projectiles[p].velocity, b.projectiles[p].velocity) << p << ' ' << step;
        ASSERT_EQ(a.projectiles[p].contact_force, b.projectiles[p].contact_force) << p << ' ' << step;
        if (!a.projectiles[p].rotation) continue;
        ASSERT_EQ(a.projectiles[p].rotation->moment, b.projectiles[p].rotation->moment) << p << ' ' << step;
    }
}

/// The energies at the end of a run, which equal at every step those of one whose columns move about.
Balance expect_no_trace(const std::vector<std::string>& overrides, int steps) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with(overrides);
    Simulation still(scene, comm), moved(scene, comm);
    constexpr int between = 50;
    for (int n = 0; n < steps; ++n) {
        still.advance_forces();
        moved.advance_forces();
        if (n % between == 0) {
            const auto a = still.balance(), b = moved.balance();
            expect_same_projectiles(a, b, n);
            EXPECT_EQ(a.contact, b.contact) << n;
            EXPECT_EQ(a.contact_friction, b.contact_friction) << n;
            EXPECT_EQ(a.internal, b.internal) << n;
            EXPECT_EQ(a.kinetic_fabric, b.kinetic_fabric) << n;
            EXPECT_EQ(a.eroded, b.eroded) << n;
            EXPECT_EQ(a.broken_yarns, b.broken_yarns) << n;
        }
        still.integrate();
        moved.integrate();
        if (n % between == between / 2)
            moved.redistribute(scattered(moved.panel(), comm.size(), n / between));
        EXPECT_EQ(still.time(), moved.time()) << n;
    }
    still.advance_forces();
    return still.balance();
}

TEST(Redistribution, LeavesNoTraceInAPerforation) {
    const auto end = expect_no_trace(perforated, 600);
    EXPECT_GT(end.eroded_elements, 0);  // the scene does what it is here for
    EXPECT_GT(end.contact, 0);
}

TEST(Redistribution, LeavesNoTraceInContactFriction) {
    const auto end = expect_no_trace(with_friction, 400);
    EXPECT_GT(*end.contact_friction, 1e-3 * end.contact);
}

TEST(Redistribution, LeavesNoTraceInTheShotsOfTwoProjectiles) {
    const auto end = expect_no_trace(two_projectiles, 400);
    EXPECT_LT(end.projectiles[0].velocity.z(), 590);  // m/s
    EXPECT_LT(end.projectiles[1].velocity.z(), 690);
}

TEST(Redistribution, LeavesNoTraceInAClampThatSlips) {
    const auto end = expect_no_trace(clamped, 600);
    EXPECT_GT(*end.contact_friction, 1e-3);  // J
}

TEST(Redistribution, LeavesNoTraceInTheTimeStepOfSlackYarns) {
    const auto end = expect_no_trace(slack, 400);
    EXPECT_LT(end.projectiles[0].velocity.z(), 140);
}

/// State of all nodes that a rank holds, as `restore` takes them.
state::Table nodes_of(Simulation& simulation) {
    state::Table table{simulation.model().nodes.ids, {}};
    state::ColumnWriter archive(table);
    for (std::size_t n = 0; n < table.ids.size(); ++n) {
        archive.start(n);
        visit_node(archive, simulation.model(), n);
    }
    return table;
}

TEST(SavedState, ThatLacksAnElementsFieldOnOneRankIsRefusedOnAll) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with(perforated);
    Simulation simulation(scene, comm);
    auto saved = simulation.save();
    saved.nodes = nodes_of(simulation);
    if (comm.rank() == comm.size() - 1)
        std::erase_if(saved.elements.columns, [](const auto& column) { return column.name == "fabric.N_f"; });
    try {
        simulation.restore(std::move(saved));
        FAIL();
    } catch (const state::Mismatch& mismatch) {
        EXPECT_TRUE(std::string(mismatch.what()).starts_with("it holds no fabric.N_f of item "))
            << mismatch.what();
    }
}

void expect_same_shot(const Shot& whole, const Shot& next) {
    const auto &a = whole.passages.plies(), &b = next.passages.plies();
    for (std::size_t ply = 0; ply < a.size(); ++ply) {
        ASSERT_EQ(a[ply].has_value(), b[ply].has_value());
        if (!a[ply]) continue;
        EXPECT_EQ(a[ply]->time, b[ply]->time);
        EXPECT_EQ(a[ply]->way, b[ply]->way);
        EXPECT_EQ(a[ply]->element, b[ply]->element);
    }
    EXPECT_EQ(whole.touched, next.touched);
    EXPECT_EQ(whole.last_touched, next.last_touched);
    EXPECT_EQ(whole.turned_back, next.turned_back);
}

/// What a run would tell of its past.
void expect_same_past(const Simulation& whole, const Simulation& next) {
    for (std::size_t p = 0; p < whole.shots().size(); ++p)
        expect_same_shot(whole.shots()[p], next.shots()[p]);
    EXPECT_EQ(whole.projectile_overlap().depth, next.projectile_overlap().depth);
    EXPECT_EQ(whole.model().surface.on_free_edge.empty(), next.model().surface.on_free_edge.empty());
    EXPECT_EQ(whole.counts().largest_internal, next.counts().largest_internal);
}

/// Goes on from a saved state beside the run that was saved.
void expect_same_future(Simulation& whole, const scene::Scene& scene, int steps,
                        const parallel::Communicator& comm) {
    auto saved = whole.save();
    saved.nodes = nodes_of(whole);  // both have the same columns on each rank
    Simulation next(scene, comm);
    next.restore(std::move(saved));
    for (int n = 0; n < steps; ++n) {
        whole.advance_forces();
        next.advance_forces();
        const auto a = whole.record_balance(), b = next.record_balance();
        expect_same_projectiles(a, b, n);
        ASSERT_EQ(a.internal, b.internal) << n;
        ASSERT_EQ(a.contact, b.contact) << n;
        ASSERT_EQ(a.contact_friction, b.contact_friction) << n;
        ASSERT_EQ(a.broken_yarns, b.broken_yarns) << n;
        ASSERT_EQ(a.transferred_energy, b.transferred_energy) << n;
        ASSERT_EQ(a.deepest.overlap, b.deepest.overlap) << n;
        whole.integrate();
        next.integrate();
        ASSERT_EQ(whole.time(), next.time()) << n;
        ASSERT_EQ(whole.time_step(), next.time_step()) << n;
    }
    for (std::size_t ply = 0; ply < whole.counts().first_break.size(); ++ply)
        EXPECT_EQ(comm.min(whole.counts().first_break[ply]), comm.min(next.counts().first_break[ply]));
    expect_same_past(whole, next);
}

TEST(SavedState, IsAllThatARunDependsOn) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    for (const auto& [overrides, before] :
         {std::pair(&perforated, 300), std::pair(&slack, 300), std::pair(&onto_the_frame, 60),
          std::pair(&with_friction, 300), std::pair(&onto_the_frame_with_friction, 60),
          std::pair(&clamped, 600), std::pair(&two_projectiles, 300)}) {
        const auto scene = scene_with(*overrides);
        Simulation whole(scene, comm);
        for (int n = 0; n < before; ++n) whole.advance_forces(), whole.integrate();
        // Of five states one after the other, the time step is due to be adapted at the first step after one
        // only.
        for (int k = 0; k < 5; ++k) expect_same_future(whole, scene, 31, comm);
    }
}

/// Fragments have all broken off: no later step would find the free edges again by itself.
TEST(SavedState, KnowsOfErosionsBefore) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with(perforated);
    Simulation whole(scene, comm);
    for (int n = 0; n < 600; ++n) whole.advance_forces(), whole.integrate();
    ASSERT_TRUE(comm.any(whole.counts().eroded_elements > 0));
    expect_same_future(whole, scene, 1, comm);
}

}  // namespace
}  // namespace weavefront::solver::test
