#pragma once
/// @file
/// What the coupling of fill and warp leaves on the free edges of a ply.

#include <limits>

#include "weavefront/mesh/panel.hpp"

namespace weavefront::solver {

/// By how much the omega^2 of a ply with free edges may be above the omega^2 of an element inside it, when
/// the area's second variation is added to all elements, 1/s2. What is left on the edges is c u_i x u_j of
/// neighbouring nodes.
/// @param inside   of an element inside, less its hourglass modes, 1/s2
/// @param coupling 4 c over the mass of an element on the edge, 1/s2
[[nodiscard]] double excess_on_edge(double inside, double coupling);
/// The same at a corner between two free edges.
[[nodiscard]] double excess_at_corner(double inside, double coupling);

/// The elements of a panel on whose edges a coupling leaves something.
struct FreeEdges {
    double edge = std::numeric_limits<double>::infinity(), corner = edge;  ///< least areas, m2
    bool too_near = false;  ///< an element has two free edges opposite each other
};
[[nodiscard]] FreeEdges free_edges(const mesh::Panel& panel);

/// Least area of an element, m2.
[[nodiscard]] double smallest_area(const mesh::Panel& panel);

}  // namespace weavefront::solver
