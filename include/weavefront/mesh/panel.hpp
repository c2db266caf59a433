#pragma once
/// @file
/// The panel: a rectangular target of plies over one common grid of columns. It is described, not stored: ids
/// and coordinates are computed, so that no rank has to hold the whole mesh.

#include <array>
#include <cstdint>
#include <vector>

#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::mesh {

/// A column is one footprint cell with the elements of all plies over it.
///
/// Canonical (global) ids: column c = j * columns_x + i; element = ply * columns + c; node = ply *
/// nodes_per_ply + j * (columns_x + 1) + i.
struct Panel {
    std::vector<double> x;           ///< grid lines, ascending, m
    std::vector<double> y;           ///< grid lines, ascending, m
    std::vector<scene::Ply> plies;   ///< from the struck side
    std::array<bool, 2> symmetry{};  ///< the first line of x (y) is a plane of symmetry
    std::array<scene::Edge, 2> edges{};

    [[nodiscard]] std::int64_t columns_x() const { return static_cast<std::int64_t>(x.size()) - 1; }
    [[nodiscard]] std::int64_t columns_y() const { return static_cast<std::int64_t>(y.size()) - 1; }
    [[nodiscard]] std::int64_t columns() const { return columns_x() * columns_y(); }
    [[nodiscard]] std::int64_t nodes_per_ply() const { return (columns_x() + 1) * (columns_y() + 1); }
    [[nodiscard]] std::int64_t elements() const {
        return columns() * static_cast<std::int64_t>(plies.size());
    }
    [[nodiscard]] std::int64_t nodes() const {
        return nodes_per_ply() * static_cast<std::int64_t>(plies.size());
    }

    /// Length of the shortest edge of an element, m.
    [[nodiscard]] double smallest_edge() const;

    /// The four footprint nodes of a column, counter-clockwise seen from +z, from 0 to nodes_per_ply() - 1.
    [[nodiscard]] std::array<std::int64_t, 4> footprint(std::int64_t column) const;

    /// Initial position of a footprint node on a ply, m.
    [[nodiscard]] Vec3 position(std::int32_t ply, std::int64_t footprint_node) const;

    /// Directions in which a footprint node cannot move: bit 0 x, bit 1 y, bit 2 z.
    [[nodiscard]] std::uint8_t supports(std::int64_t footprint_node) const;

    /// How many times the modelled part makes the whole target: 1, 2 or 4.
    [[nodiscard]] int multiplicity() const { return (symmetry[0] ? 2 : 1) * (symmetry[1] ? 2 : 1); }
};

/// The panel of a scene's target, graded around the point under the projectile's axis (the origin if there is
/// none).
/// @throws std::invalid_argument when the scene has no target
Panel make_panel(const scene::Scene& scene);

}  // namespace weavefront::mesh
