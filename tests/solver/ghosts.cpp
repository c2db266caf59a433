/// Ghosts are what their owners have, and are replaced no more often than needed.

#include "weavefront/solver/ghosts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

/// Where all nodes are, by their owners.
std::vector<double> all_positions(const Simulation& simulation, const parallel::Communicator& comm) {
    const auto& nodes = simulation.model().nodes;
    std::vector<double> all(static_cast<std::size_t>(3 * simulation.panel().nodes()),
                            std::numeric_limits<double>::lowest());
    for (std::size_t n = 0; n < nodes.ids.size(); ++n)
        if (nodes.owned[n]) std::ranges::copy(nodes.x[n], all.begin() + 3 * nodes.ids[n]);
    comm.max(all);
    return all;
}

TEST(Ghosts, AreWhereTheirOwnersHaveThem) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"target.plies.count=3",
                                      "fabrics.kevlar129.failure={static_strain: 3.3 %, hooke_strain: 2.7 %}",
                                      "projectile.velocity=[0, 0, 600 m/s]"}),
                          comm);
    const auto& panel = simulation.panel();
    const auto& surface = simulation.model().surface;
    std::int64_t ghosts = 0;
    for (int round = 0; round < 10; ++round) {
        advance(simulation, 60);
        const auto all = all_positions(simulation, comm);
        for (auto f = static_cast<std::size_t>(surface.owned); f < surface.facets.size(); ++f, ++ghosts) {
            const auto& facet = surface.facets[f];
            const auto corners = panel.footprint(facet.id % panel.columns());
            for (std::size_t a = 0; a < 4; ++a) {
                const auto node = 3 * (corners[a] + facet.id / panel.columns() * panel.nodes_per_ply());
                const Vec3 swept(all.data() + node);
                ASSERT_EQ(simulation.model().nodes.x[static_cast<std::size_t>(facet.nodes[a])], swept)
                    << round << ' ' << facet.id;
            }
        }
    }
    EXPECT_GT(simulation.counts().searches, 3);
    EXPECT_EQ(ghosts > 0, comm.size() > 1);
}

TEST(Ghosts, AreReplacedOnlyWhereTheyDoNotSuffice) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene = scene_with({"target.plies.count=2"});
    Simulation simulation(scene, comm);
    auto& model = simulation.model();
    auto& nodes = model.nodes;
    auto& surface = model.surface;
    constexpr double reach = 1e-3, spare = 0.4e-3;  // facets are 2 mm wide
    Ghosts ghosts;
    ForceExchange exchange;
    const auto renewed = [&] {
        const contact::SweptBounds swept(nodes.x);
        const bool anew = ghosts.renew(comm, model.halo, swept, reach, spare, surface, nodes, exchange);
        EXPECT_FALSE(ghosts.renew(comm, model.halo, swept, reach, spare, surface, nodes, exchange));
        return anew;
    };
    const auto slide = [&](double way) {
        for (std::size_t n = 0; n < nodes.x.size(); ++n)
            if (nodes.x[n].z() > 0) nodes.x[n] += Vec3(way, way, 0);
    };
    const bool several = comm.size() > 1;
    EXPECT_TRUE(renewed());
    slide(spare / 2);
    EXPECT_FALSE(renewed());
    slide(2e-3);
    EXPECT_EQ(renewed(), several);
    surface.on_free_edge.assign(surface.facets.size(), 0);
    EXPECT_FALSE(renewed());
    if (comm.rank() == 0) std::fill_n(surface.on_free_edge.begin(), surface.owned, 1);
    EXPECT_EQ(renewed(), several);
    if (comm.rank() == 0) std::fill_n(surface.alive.begin(), surface.owned, 0);
    EXPECT_EQ(renewed(), several);
}

}  // namespace
}  // namespace weavefront::solver::test
