#include "weavefront/solver/coupling_on_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace weavefront::solver {

namespace {

/// The edges of a line of elements that lie on an edge of the ply.
struct Ends {
    double shortest_end, shortest;  ///< m
    bool free;
    bool two_ends;
};

Ends ends_of(const std::vector<double>& line, bool symmetric, scene::Edge edge) {
    double shortest = line[1] - line[0];
    for (std::size_t i = 1; i + 1 < line.size(); ++i) shortest = std::min(shortest, line[i + 1] - line[i]);
    const double last = line[line.size() - 1] - line[line.size() - 2];
    return {symmetric ? last : std::min(last, line[1] - line[0]), shortest, edge != scene::Edge::fixed,
            !symmetric};
}

}  // namespace

// The gradients of an element contain half of a node's displacement: the corners' values less their mean and
// their hourglass mode. An edge couples x of one node with y of the next, both halved. With a inside and the
// coupling l, the eigenvalue is that of {{a + l/4, l/4}, {l/4, l/4}}.
double excess_on_edge(double inside, double coupling) {
    const double a = std::max(inside, 0.0);
    return coupling / 4 - a / 2 + std::sqrt(a * a / 4 + coupling * coupling / 16);
}

// A corner couples the corner node, halved, with the difference of its neighbours, which counts whole. The
// matrix is {{a, 0, l/2}, {0, 0, l/2}, {l/2, l/2, a}}. Its largest eigenvalue a + x solves
// x^2 = l^2/4 (a + 2 x)/(a + x). The iteration starts above the solution and stays above it.
double excess_at_corner(double inside, double coupling) {
    const double a = std::max(inside, 0.0);
    double x = coupling / std::numbers::sqrt2;
    for (int i = 0; i < 6 && x > 0; ++i) x = coupling / 2 * std::sqrt((a + 2 * x) / (a + x));
    return x;
}

FreeEdges free_edges(const mesh::Panel& panel) {
    const Ends x = ends_of(panel.x, panel.symmetry[0], panel.edges[0]),
               y = ends_of(panel.y, panel.symmetry[1], panel.edges[1]);
    FreeEdges edges;
    if (x.free) edges.edge = x.shortest_end * y.shortest;
    if (y.free) edges.edge = std::min(edges.edge, x.shortest * y.shortest_end);
    if (x.free && y.free) edges.corner = x.shortest_end * y.shortest_end;
    edges.too_near =
        (x.free && x.two_ends && panel.columns_x() < 2) || (y.free && y.two_ends && panel.columns_y() < 2);
    return edges;
}

double smallest_area(const mesh::Panel& panel) {
    return ends_of(panel.x, false, panel.edges[0]).shortest *
           ends_of(panel.y, false, panel.edges[1]).shortest;
}

}  // namespace weavefront::solver
