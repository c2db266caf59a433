#include "weavefront/partition/halo_plan.hpp"

#include <map>
#include <span>

#include "weavefront/partition/halo_sizes.hpp"

namespace weavefront::partition {

HaloPlan make_halo_plan(const mesh::Panel& panel, const Decomposition& decomposition, const mesh::Part& part,
                        int rank) {
    HaloPlan plan;
    plan.owned.resize(part.node_ids.size());
    std::map<int, std::vector<std::int32_t>> shared;
    for (std::size_t n = 0; n < part.node_ids.size(); ++n) {
        const auto holders = holders_of(panel, decomposition, part.node_ids[n] % panel.nodes_per_ply());
        plan.owned[n] = holders.parts.front() == rank;
        for (const int other : std::span(holders.parts).first(static_cast<std::size_t>(holders.count)))
            if (other != rank) shared[other].push_back(static_cast<std::int32_t>(n));
    }
    for (auto& [other, nodes] : shared) plan.neighbours.push_back({other, std::move(nodes)});
    return plan;
}

}  // namespace weavefront::partition
