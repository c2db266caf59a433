#pragma once
/// @file
/// Nodes of one rank.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/mesh/repeated.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::solver {

/// A nodal force as integers of one FixedPoint.
using FixedVector = std::array<std::int64_t, 3>;

/// Initial positions of the nodes of a part: every ply has the same in x and y and lies at one height.
struct InitialPositions {
    mesh::Repeated<std::array<double, 2>> in_plane;  ///< m
    std::vector<double> heights;                     ///< of the plies, m

    [[nodiscard]] std::size_t size() const { return in_plane.one_ply.size() * heights.size(); }
    [[nodiscard]] Vec3 operator[](std::size_t node) const {
        const auto& [x, y] = in_plane[node];
        return {x, y, height(node)};
    }
    [[nodiscard]] double height(std::size_t node) const { return heights[node / in_plane.one_ply.size()]; }
};

/// The rank's own nodes come first, then the ghosts that contact needs. A node on the border between parts,
/// or near to one, stands on every rank that knows it; each of them moves it, with the same bits.
struct Nodes {
    std::int32_t count = 0;              ///< without ghosts
    std::vector<std::int64_t> ids;       ///< global, ascending
    std::vector<bool> owned;             ///< one of the ranks that hold a node owns it: it counts there
    std::vector<Vec3> x, v;              ///< with ghosts, m, m/s; v is half a step behind x
    InitialPositions initial;            ///< without ghosts
    std::vector<double> mass;            ///< with ghosts, kg
    std::vector<std::uint8_t> supports;  ///< with ghosts; bit 0 x, bit 1 y, bit 2 z held
    std::vector<FixedVector> force;      ///< with ghosts

    /// Makes room for so many ghosts.
    void resize_ghosts(std::size_t ghosts) {
        const auto all = static_cast<std::size_t>(count) + ghosts;
        x.resize(all), v.resize(all), mass.resize(all), supports.resize(all), force.resize(all);
    }

    [[nodiscard]] std::span<const Vec3> own_x() const { return {x.data(), static_cast<std::size_t>(count)}; }
};

}  // namespace weavefront::solver
