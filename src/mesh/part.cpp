#include "weavefront/mesh/part.hpp"

#include <algorithm>

namespace weavefront::mesh {

namespace {

std::int32_t find(const std::vector<std::int64_t>& ids, std::int64_t id) {
    const auto found = std::lower_bound(ids.begin(), ids.end(), id);
    return found != ids.end() && *found == id ? static_cast<std::int32_t>(found - ids.begin()) : -1;
}

std::vector<std::int64_t> footprint_nodes(const Panel& panel, std::span<const std::int64_t> columns) {
    std::vector<std::int64_t> nodes;
    nodes.reserve(4 * columns.size());
    for (const auto column : columns)
        for (const auto node : panel.footprint(column)) nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace

std::int32_t Part::local_node(std::int64_t id) const { return find(node_ids, id); }
std::int32_t Part::local_element(std::int64_t id) const { return find(element_ids, id); }

Part make_part(const Panel& panel, std::span<const std::int64_t> columns) {
    const auto footprint = footprint_nodes(panel, columns);
    const auto plies = static_cast<std::int32_t>(panel.plies.size());
    Part part;
    for (std::int32_t ply = 0; ply < plies; ++ply) {
        const auto offset = static_cast<std::int32_t>(part.node_ids.size());
        for (const auto node : footprint) {
            part.node_ids.push_back(ply * panel.nodes_per_ply() + node);
            part.positions.push_back(panel.position(ply, node));
            part.supports.push_back(panel.supports(node));
        }
        for (const auto column : columns) {
            std::array<std::int32_t, 4> nodes{};
            std::ranges::transform(panel.footprint(column), nodes.begin(),
                                   [&](auto node) { return offset + find(footprint, node); });
            part.element_ids.push_back(ply * panel.columns() + column);
            part.element_nodes.push_back(nodes);
            part.element_plies.push_back(ply);
        }
    }
    return part;
}

}  // namespace weavefront::mesh
