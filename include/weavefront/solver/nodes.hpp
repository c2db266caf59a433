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

    [[nodiscard]] std::size_t size() const { return in_plane.period.size() * heights.size(); }
    [[nodiscard]] Vec3 operator[](std::size_t node) const {
        const auto& [x, y] = in_plane[node];
        return {x, y, heights[node / in_plane.period.size()]};
    }
};

/// Positions and velocities stand for the rank's own nodes first, then for the ghosts that contact needs. A node on the border between
/// parts stands on every rank that touches it, with the same bits.
struct Nodes {
    std::int32_t count = 0;              ///< without ghosts
    std::vector<std::int64_t> ids;       ///< global, ascending
    std::vector<bool> owned;             ///< one of the ranks that hold a node owns it: it counts there
    std::vector<Vec3> x, v;              ///< with ghosts, m, m/s; v is half a step behind x
    InitialPositions initial;            ///< without ghosts
    std::vector<double> mass;            ///< kg
    std::vector<std::uint8_t> supports;  ///< bit 0 x, bit 1 y, bit 2 z held
    std::vector<FixedVector> force;      ///< with ghosts

    [[nodiscard]] std::span<const Vec3> own_x() const { return {x.data(), static_cast<std::size_t>(count)}; }
};

}  // namespace weavefront::solver
