#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "small_scene.hpp"
#include "weavefront/solver/redistribution.hpp"

namespace weavefront::solver::test {

namespace {

/// A ply slides over another by three facets before they touch; a corner flies off on its own.
scene::Scene two_plies() {
    return scene_with({"target.plies.count=2", "projectile=", "contact={plies: {}, spacing: 0.5 mm}"});
}

void slide(Simulation& simulation) {
    const double last = simulation.model().nodes.initial.heights.back();
    set_motion(
        simulation, [](const Vec3& x) { return x; },
        [&](const Vec3& x) {
            if (x.x() > 11.9e-3 && x.y() > 11.9e-3) return Vec3(900, -700, 0);
            return x.z() == last ? Vec3(400, 150, -7) : Vec3(0, 0, 0);
        });
}

/// Each rank's own facets and ghosts are on a rim where the whole target, whose x edges are fixed and whose y
/// edges are free, says so.
void expect_rims_of_the_whole(const Simulation& simulation, const parallel::Communicator& comm) {
    const auto& panel = simulation.panel();
    const auto& model = simulation.model();
    const auto nodes_of = [&](std::int64_t element) {
        auto nodes = panel.footprint(element % panel.columns());
        for (auto& node : nodes) node += element / panel.columns() * panel.nodes_per_ply();
        return nodes;
    };
    std::vector<std::int64_t> lost(static_cast<std::size_t>(panel.nodes()), 0);
    for (std::int64_t node = 0; node < panel.nodes(); ++node) {
        const auto at = panel.position(0, node % panel.nodes_per_ply());
        const bool held = std::abs(at.x()) > 11.9e-3,
                   on_free_edge = std::abs(at.y()) > 11.9e-3;  // the target is 24 mm wide
        lost[static_cast<std::size_t>(node)] = on_free_edge && !held && comm.rank() == 0;
    }
    for (std::size_t f = 0; f < static_cast<std::size_t>(model.surface.owned); ++f)
        if (!model.surface.alive[f])
            for (const auto node : nodes_of(model.surface.facets[f].id))
                lost[static_cast<std::size_t>(node)] = 1;
    comm.sum(lost);
    std::int64_t rims = 0;
    for (std::size_t f = 0; f < model.surface.facets.size(); ++f) {
        if (!model.surface.alive[f]) continue;
        const auto nodes = nodes_of(model.surface.facets[f].id);
        const bool on_free_edge =
            std::ranges::any_of(nodes, [&](auto node) { return lost[static_cast<std::size_t>(node)] > 0; });
        ASSERT_EQ(model.surface.on_free_edge[f] != 0, on_free_edge) << model.surface.facets[f].id;
        rims += on_free_edge;
    }
    comm.sum({&rims, 1});
    EXPECT_GT(rims, 10);
}

}  // namespace

// Forces are those of a target for which what may meet is looked for every other step.
TEST(Search, ComesInTime) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = two_plies();
    Simulation sparing(scene, comm), eager(scene, comm);
    slide(sparing), slide(eager);
    partition::Decomposition columns{comm.size(), {}};
    for (std::int64_t c = 0; c < eager.panel().columns(); ++c)
        columns.owner.push_back(static_cast<std::int32_t>(c % comm.size()));
    double most = 0;
    for (int steps = 0; sparing.time() < 25e-6; ++steps) {
        sparing.advance_forces();
        eager.advance_forces();
        if (steps % 20 == 0) {
            const auto a = sparing.balance(), b = eager.balance();
            ASSERT_EQ(a.contact, b.contact) << steps;
            ASSERT_EQ(a.kinetic_fabric, b.kinetic_fabric) << steps;
            most = std::max(most, a.contact);
        }
        sparing.integrate();
        eager.integrate();
        if (steps % 2 == 0) eager.redistribute(columns);
    }
    EXPECT_GT(most, 0);
}

// When what may meet is looked for does not matter to plies with holes, through which others are met, and
// with debris in flight either.
TEST(Search, MayComeAtAnyTime) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with(
        {"target.plies.count=4", "fabrics.kevlar129.failure={static_strain: 3.3 %, hooke_strain: 2.7 %}",
         "target.edges={x: fixed, y: free}", "projectile.velocity=[0, 0, 600 m/s]", "projectile.mass=2 g"});
    Simulation sparing(scene, comm), eager(scene, comm);
    partition::Decomposition columns{comm.size(), {}};
    for (std::int64_t c = 0; c < eager.panel().columns(); ++c)
        columns.owner.push_back(static_cast<std::int32_t>(c % comm.size()));
    for (int steps = 0; sparing.time() < 60e-6; ++steps) {
        advance(sparing, 1);
        advance(eager, 1);
        if (steps % 2 == 0) eager.redistribute(columns);
    }
    sparing.advance_forces();
    eager.advance_forces();
    const auto a = sparing.balance(), b = eager.balance();
    EXPECT_GT(a.eroded_elements, 20);
    EXPECT_EQ(a.contact, b.contact);
    EXPECT_EQ(a.kinetic_fabric, b.kinetic_fabric);
    expect_rims_of_the_whole(sparing, comm);
    expect_rims_of_the_whole(eager, comm);
}

}  // namespace weavefront::solver::test
