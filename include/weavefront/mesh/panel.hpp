#pragma once
/// @file
/// The panel: a rectangular target of plies over one common grid of columns. Ids and coordinates are
/// computed, so no rank holds the whole mesh.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::mesh {

/// Grid and plies of the target. A column is one cell of the grid with the elements of all plies over it.
///
/// Canonical (global) ids: column c = j * columns_x + i; element = ply * columns + c; node = ply *
/// nodes_per_ply + j * (columns_x + 1) + i.
struct Panel {
    std::vector<double> x;           ///< grid lines, ascending, m
    std::vector<double> y;           ///< grid lines, ascending, m
    std::vector<scene::Ply> plies;   ///< struck side first
    std::array<bool, 2> symmetry{};  ///< whether the first line of x (y) is a plane of symmetry
    std::array<scene::Edge, 2> edges{};
    std::optional<scene::Frame> frame;  ///< beyond whose opening the fabric is held as its edges are

    /// Number of columns along x.
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

    /// The direction, 0 x or 1 y, of the edge that is a clamp and holds a footprint node; none outside of
    /// clamps.
    [[nodiscard]] std::optional<std::size_t> clamp_of(std::int64_t footprint_node) const;

    /// Copies of the modelled part in the whole target: 1, 2 or 4.
    [[nodiscard]] int multiplicity() const { return (symmetry[0] ? 2 : 1) * (symmetry[1] ? 2 : 1); }
};

/// The panel of a scene's target, graded around the axis of the first projectile. Without a projectile the
/// origin takes its place.
/// @throws std::invalid_argument when the scene has no target
Panel make_panel(const scene::Scene& scene);

}  // namespace weavefront::mesh
