#include "free_edges.hpp"

#include <algorithm>

#include "weavefront/solver/ghosts.hpp"

namespace weavefront::solver {

namespace {

/// Whether a node lies on an edge of its ply that may move in the plane.
bool on_moving_edge(const mesh::Panel& panel, std::int64_t footprint_node) {
    constexpr std::uint8_t in_plane = 3;
    if ((panel.supports(footprint_node) & in_plane) == in_plane) return false;
    const auto i = footprint_node % (panel.columns_x() + 1), j = footprint_node / (panel.columns_x() + 1);
    return (i == 0 && !panel.symmetry[0]) || i == panel.columns_x() || (j == 0 && !panel.symmetry[1]) ||
           j == panel.columns_y();
}

}  // namespace

void find_free_edges(const parallel::Communicator& comm, const mesh::Panel& panel, Model& model) {
    auto& surface = model.surface;
    const auto owned = static_cast<std::size_t>(surface.owned);
    std::vector<FixedVector> lost(model.nodes.ids.size(),
                                  FixedVector{});  // in the first component: neighbours around each node
    for (std::size_t n = 0; n < lost.size(); ++n)
        lost[n][0] = on_moving_edge(panel, model.nodes.ids[n] % panel.nodes_per_ply());
    for (std::size_t f = 0; f < owned; ++f)
        if (!surface.alive[f])
            for (const auto node : surface.facets[f].nodes) ++lost[static_cast<std::size_t>(node)][0];
    halo_exchange(model.halo).sum(comm, lost);
    surface.on_free_edge.resize(surface.facets.size());
    for (std::size_t f = 0; f < owned; ++f)
        surface.on_free_edge[f] =
            surface.alive[f] != 0 && std::ranges::any_of(surface.facets[f].nodes, [&](auto node) {
                return lost[static_cast<std::size_t>(node)][0] > 0;
            });
}

}  // namespace weavefront::solver
