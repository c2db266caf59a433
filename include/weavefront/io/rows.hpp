#pragma once
/// @file
/// What a run hands to the writers, as plain data in SI, for the whole target (also when a symmetric part is
/// modelled).

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace weavefront::io {

/// Columns of a projectile that turns, in the axes of space.
struct Rotation {
    std::array<double, 4> attitude{};          ///< quaternion w, x, y, z from its axes to those of space
    std::array<double, 3> angular_velocity{};  ///< rad/s
    std::array<double, 3> moment{};            ///< of the contact, about its centre of mass, N m
};

/// Columns of a projectile.
struct ProjectileRow {
    std::array<double, 3> position{};       ///< of the nose, m
    std::array<double, 3> velocity{};       ///< m/s
    std::array<double, 3> contact_force{};  ///< of the fabric on the projectile, N
    std::optional<Rotation> rotation = {};  ///< in all rows of a file, or in none
};

/// One row of history.csv. The columns are written in this order, those of the second and further projectiles
/// at the end.
struct HistoryRow {
    double time = 0;
    std::vector<ProjectileRow> projectiles;  ///< the first one's columns are 0 where there is none
    double kinetic_fabric = 0;               ///< J, as all energies
    double kinetic_projectile = 0;           ///< of all projectiles
    double internal = 0;
    double hourglass = 0;
    double contact = 0;   ///< stored and damped in contact, without its friction
    double friction = 0;  ///< of yarns
    double damping = 0;
    double external = 0;
    double eroded = 0;  ///< hourglass energy let go with broken yarns and eroded elements, in no other column
    double energy_error = 0;        ///< closure error over the initial total energy
    std::int64_t broken_yarns = 0;  ///< element-directions
    std::int64_t eroded_elements = 0;
    double max_displacement = 0;      ///< largest displacement along z of a node of joined fabric, m
    double time_step = 0;             ///< s
    double back_face_deflection = 0;  ///< largest displacement along z of joined fabric of the last ply, m
    double penetration =
        0;  ///< deepest that fabric and the projectile, another ply or the frame overlapped until then, m
    std::array<double, 2> penetration_at{};       ///< its place in x and y, m
    std::int64_t penetration_ply = 0;             ///< its ply, 1 = struck first; 0: nothing was in contact
    std::int64_t debris_elements = 0;             ///< neither eroded nor joined to a support
    double debris_mass = 0;                       ///< kg
    double debris_displacement = 0;               ///< largest displacement along z of a node of debris, m
    std::optional<double> contact_friction = {};  ///< taken by contact friction; in all rows, or in none
};

/// The global topology of the results in canonical order, of which each rank passes the part it owns. Every
/// node and every element is owned by exactly one rank.
struct Topology {
    std::int64_t nodes = 0;                                 ///< of the whole fabric
    std::int64_t elements = 0;                              ///< of the whole fabric
    std::vector<std::int64_t> owned_nodes;                  ///< global ids, ascending
    std::vector<std::int64_t> owned_elements;               ///< global ids, ascending
    std::vector<std::array<std::int64_t, 4>> connectivity;  ///< global node ids of the owned elements
    std::vector<std::int32_t> ply;                          ///< of the owned elements, 1 = struck first
};

/// Surfaces of the projectiles, the same on all ranks, each relative to its nose. Empty without a projectile.
struct Surface {
    std::vector<std::array<double, 3>> points;       ///< m
    std::vector<std::array<std::int64_t, 4>> quads;  ///< indices into `points`
};

/// One array of a frame: `values` holds `components` doubles for every owned node (or element), in the order
/// of Topology.
struct Array {
    std::string name;
    int components = 1;
    bool integer = false;  ///< stored as int8 (flags)
    std::vector<double> values;
    std::vector<double> projectile;  ///< of the points (or quads) of the surface; empty: zeros
};

/// One frame of results.vtkhdf.
struct Frame {
    double time = 0;
    std::vector<double> points;  ///< current positions of the owned nodes, xyz xyz ..., m
    std::vector<Array> point_data;
    std::vector<Array> cell_data;
    std::vector<bool> eroded;        ///< of the owned elements: hidden in the pictures
    std::vector<double> projectile;  ///< current positions of the points of its surface, xyz xyz ..., m
};

}  // namespace weavefront::io
