#pragma once
/// @file
/// The part of a target that one rank computes.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::mesh {

/// Owned elements and their nodes, in ascending global order.
struct Part {
    std::vector<std::int64_t> node_ids;                      ///< global
    std::vector<Vec3> positions;                             ///< initial, m
    std::vector<std::uint8_t> supports;                      ///< bit 0 x, bit 1 y, bit 2 z held
    std::vector<std::int64_t> element_ids;                   ///< global
    std::vector<std::array<std::int32_t, 4>> element_nodes;  ///< local, counter-clockwise seen from +z
    std::vector<std::int32_t> element_plies;                 ///< 0 = struck first

    /// Local index of a global node, -1 if it is not in this part.
    [[nodiscard]] std::int32_t local_node(std::int64_t id) const;
    /// Local index of a global element, -1 if it is not in this part.
    [[nodiscard]] std::int32_t local_element(std::int64_t id) const;
};

/// Builds the part of a panel that consists of the given columns.
/// @param columns ascending column ids
Part make_part(const Panel& panel, std::span<const std::int64_t> columns);

}  // namespace weavefront::mesh
