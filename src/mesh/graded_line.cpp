#include "weavefront/mesh/graded_line.hpp"

#include <algorithm>

namespace weavefront::mesh {

namespace {

// No element is thinner than a quarter of its neighbour, since a sliver would set the time step of the whole
// run. The smallest element of a side of two or more is at least 1/(1 + growth) of the requested size. So
// this growth keeps the limit.
constexpr double thinnest = 0.25, most_growth = 3;

/// Distances of the grid lines of one side from the fine point, ascending, the first one 0 and the last one
/// `length`.
std::vector<double> one_side(double length, const scene::PanelMesh& mesh) {
    std::vector<double> distance{0};
    double size = mesh.center;
    // A remainder below a millionth of an element is rounding, not another element.
    while (distance.back() < length - 1e-6 * size) {
        distance.push_back(distance.back() + size);
        size = std::min(size * std::min(mesh.growth, most_growth), mesh.edge);
    }
    const double scale = length / distance.back();
    if (distance.size() > 1)
        for (double& d : distance) d *= scale;
    distance.back() = length;
    return distance;
}

}  // namespace

std::vector<double> graded_line(double low, double high, double fine, const scene::PanelMesh& mesh) {
    const auto side = [&](double length) {
        return length > 0 ? one_side(length, mesh) : std::vector<double>{0};
    };
    auto below = side(fine - low), above = side(high - fine);
    // A side of one element may have any thickness. Where it is a sliver, the fine point moves to its end.
    if (below.size() == 2 && above.size() > 1 && below[1] < thinnest * above[1])
        return graded_line(low, high, low, mesh);
    if (above.size() == 2 && below.size() > 1 && above[1] < thinnest * below[1])
        return graded_line(low, high, high, mesh);
    std::vector<double> line;
    line.reserve(below.size() + above.size() - 1);
    for (auto d = below.rbegin(); d != below.rend(); ++d) line.push_back(fine - *d);
    for (auto d = above.begin() + 1; d != above.end(); ++d) line.push_back(fine + *d);
    line.front() = low;
    line.back() = high;
    return line;
}

}  // namespace weavefront::mesh
