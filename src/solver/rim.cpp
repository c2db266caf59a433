#include "rim.hpp"

#include <algorithm>

#include "weavefront/solver/ghosts.hpp"

namespace weavefront::solver {

void find_rims(const parallel::Communicator& comm, const partition::HaloPlan& plan, contact::Surface& surface) {
    const auto owned = static_cast<std::size_t>(surface.owned);
    std::vector<FixedVector> eroded(plan.owned.size(), FixedVector{});  // in the first component: how many around each node
    for (std::size_t f = 0; f < owned; ++f)
        if (!surface.alive[f])
            for (const auto node : surface.facets[f].nodes) ++eroded[static_cast<std::size_t>(node)][0];
    halo_exchange(plan).sum(comm, eroded);
    surface.on_rim.resize(surface.facets.size());
    for (std::size_t f = 0; f < owned; ++f)
        surface.on_rim[f] = surface.alive[f] != 0 && std::ranges::any_of(surface.facets[f].nodes, [&](auto node) {
                                return eroded[static_cast<std::size_t>(node)][0] > 0;
                            });
}

}  // namespace weavefront::solver
