#pragma once
/// @file
/// The terms that the coupling of fill and warp leaves on the free edges of a ply.

#include <limits>

#include "weavefront/mesh/panel.hpp"

namespace weavefront::solver {

/// The difference of omega^2 between a ply with free edges and an element inside it is at most this, 1/s2. It
/// comes from the terms c u_i x u_j of neighbouring nodes on an edge, which do not cancel.
/// @param inside   of an element inside, less its hourglass modes, 1/s2
/// @param coupling 4 c over the mass of an element on the edge, 1/s2
[[nodiscard]] double excess_on_edge(double inside, double coupling);
/// The same at a corner between two free edges.
[[nodiscard]] double excess_at_corner(double inside, double coupling);

/// The elements of a panel on whose edges terms of a coupling remain.
struct FreeEdges {
    double edge = std::numeric_limits<double>::infinity(), corner = edge;  ///< least areas, m2
    bool too_near = false;  ///< an element has two free edges opposite each other
};
[[nodiscard]] FreeEdges free_edges(const mesh::Panel& panel);

/// Least area of an element, m2.
[[nodiscard]] double smallest_area(const mesh::Panel& panel);

}  // namespace weavefront::solver
