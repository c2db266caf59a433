#pragma once
/// @file
/// The surface of the plies on one rank: owned facets and the ghost facets around them.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/bilinear_quad.hpp"
#include "weavefront/mesh/repeated.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// A quad of a ply. Every element of a rank has one, so it is packed.
struct Facet {
    std::int64_t id : 48;  ///< global element
    std::int32_t ply : 16;
    std::array<std::int32_t, 4> nodes;  ///< local, counter-clockwise about +z; beyond the owned nodes: ghosts

    Facet() : Facet(0, {}, 0) {}
    /// @param global_id below 2^47 @param ply_index below 2^15
    Facet(std::int64_t global_id, const std::array<std::int32_t, 4>& corners, std::int32_t ply_index)
        : id(global_id & 0x7fff'ffff'ffff), ply(ply_index & 0x7fff), nodes(corners) {}
};
static_assert(sizeof(Facet) == 24);

/// Properties of a ply.
struct PlyProperties {
    double z = 0;              ///< initial height, m
    double thickness = 0;      ///< contact thickness, m
    double areal_density = 0;  ///< kg/m2
};

/// Facets in ascending global order among the owned ones and among the ghosts.
struct Surface {
    std::vector<Facet> facets;        ///< owned ones first
    std::vector<std::uint8_t> alive;  ///< by facet
    /// By facet: whether it has lost a neighbour with a common node, or lies on an edge of its ply that may
    /// move. Empty while all facets are alive: each ply then meets the next one only.
    std::vector<std::uint8_t> on_free_edge;
    std::int32_t owned = 0;        ///< number of owned facets
    mesh::Repeated<double> areas;  ///< initial areas of the owned facets, m2; they repeat from ply to ply
    std::vector<PlyProperties> plies;
    std::array<bool, 2> symmetry{};  ///< whether x = 0 (y = 0) is a plane of symmetry
};

/// Axis-aligned box.
struct Box {
    Vec3 low, high;

    static Box around(const std::array<Vec3, 4>& c) {
        return {c[0].cwiseMin(c[1]).cwiseMin(c[2].cwiseMin(c[3])),
                c[0].cwiseMax(c[1]).cwiseMax(c[2].cwiseMax(c[3]))};
    }
    static Box around(const Facet& facet, std::span<const Vec3> x) {
        const auto at = [&](std::size_t a) -> const Vec3& {
            return x[static_cast<std::size_t>(facet.nodes[a])];
        };
        return {at(0).cwiseMin(at(1)).cwiseMin(at(2).cwiseMin(at(3))),
                at(0).cwiseMax(at(1)).cwiseMax(at(2).cwiseMax(at(3)))};
    }

    [[nodiscard]] bool meets(const Box& other) const {
        return (low.array() <= other.high.array()).all() && (high.array() >= other.low.array()).all();
    }
};

/// The body on which a facet presses.
enum class Master : std::uint8_t { facet, projectile, frame };

/// Contact force between a facet and another facet or a rigid body: the sum over the points of the pair, as
/// nodal forces.
struct PairForce {
    std::array<std::int32_t, 4> slave{}, master{};
    std::array<Vec3, 4> on_slave, on_master;  ///< N
    Vec3 total{0, 0, 0};                      ///< on the slave, N; the master receives the opposite
    Master kind = Master::facet;
    std::uint16_t projectile = 0;  ///< its number, where that is the master

    PairForce(const std::array<std::int32_t, 4>& slave_nodes, const std::array<std::int32_t, 4>& master_nodes)
        : slave(slave_nodes), master(master_nodes) {
        on_slave.fill(Vec3::Zero());
        on_master.fill(Vec3::Zero());
    }
    /// Fabric against a rigid body, which has no nodes.
    PairForce(const std::array<std::int32_t, 4>& slave_nodes, Master rigid, std::uint16_t number = 0)
        : PairForce(slave_nodes, std::array<std::int32_t, 4>{}) {
        kind = rigid;
        projectile = number;
    }

    /// Adds the force at one point of a batch.
    /// @param on_slave_point    N
    /// @param slave_N, master_N shape functions at the points of the batch
    void add(const Vec3& on_slave_point, const ShapeFunctions& slave_N, const ShapeFunctions& master_N,
             std::size_t lane) {
        add(on_slave_point, slave_N, lane);
        for (std::size_t a = 0; a < 4; ++a) on_master[a] -= master_N[a][lane] * on_slave_point;
    }
    /// The same against a rigid body.
    void add(const Vec3& on_slave_point, const ShapeFunctions& slave_N, std::size_t lane) {
        for (std::size_t a = 0; a < 4; ++a) on_slave[a] += slave_N[a][lane] * on_slave_point;
        total += on_slave_point;
    }
};

/// Values of the corners of a facet.
inline std::array<Vec3, 4> corners_of(const std::array<std::int32_t, 4>& nodes,
                                      std::span<const Vec3> values) {
    return {values[static_cast<std::size_t>(nodes[0])], values[static_cast<std::size_t>(nodes[1])],
            values[static_cast<std::size_t>(nodes[2])], values[static_cast<std::size_t>(nodes[3])]};
}

/// Mean of the corners of a facet.
inline Vec3 centre_of(const std::array<Vec3, 4>& corners) {
    return (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
}

}  // namespace weavefront::contact
