#include "weavefront/partition/halo_plan.hpp"

#include <algorithm>
#include <map>

namespace weavefront::partition {

namespace {

/// Ranks that hold a footprint node: the owners of the up to four columns around it.
std::vector<int> holders(const mesh::Panel& panel, const Decomposition& decomposition, std::int64_t footprint_node) {
    const auto stride = panel.columns_x() + 1;
    const auto i = footprint_node % stride, j = footprint_node / stride;
    std::vector<int> ranks;
    for (auto cj = std::max<std::int64_t>(j - 1, 0); cj <= std::min(j, panel.columns_y() - 1); ++cj)
        for (auto ci = std::max<std::int64_t>(i - 1, 0); ci <= std::min(i, panel.columns_x() - 1); ++ci)
            ranks.push_back(decomposition.owner[static_cast<std::size_t>(cj * panel.columns_x() + ci)]);
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    return ranks;
}

}  // namespace

HaloPlan make_halo_plan(const mesh::Panel& panel, const Decomposition& decomposition, const mesh::Part& part, int rank) {
    HaloPlan plan;
    plan.owned.resize(part.node_ids.size());
    std::map<int, std::vector<std::int32_t>> shared;
    for (std::size_t n = 0; n < part.node_ids.size(); ++n) {
        const auto ranks = holders(panel, decomposition, part.node_ids[n] % panel.nodes_per_ply());
        plan.owned[n] = ranks.front() == rank;
        for (const int other : ranks)
            if (other != rank) shared[other].push_back(static_cast<std::int32_t>(n));
    }
    for (auto& [other, nodes] : shared) plan.neighbours.push_back({other, std::move(nodes)});
    return plan;
}

}  // namespace weavefront::partition
