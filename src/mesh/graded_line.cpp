#include "weavefront/mesh/graded_line.hpp"

#include <algorithm>

namespace weavefront::mesh {

namespace {

/// Distances of the grid lines of one side from the fine point, ascending, the first one 0 and the last one `length`.
std::vector<double> one_side(double length, const scene::PanelMesh& mesh) {
    std::vector<double> distance{0};
    double size = mesh.center;
    // A remainder below a millionth of an element is rounding, not another element.
    while (distance.back() < length - 1e-6 * size) {
        distance.push_back(distance.back() + size);
        size = std::min(size * mesh.growth, mesh.edge);
    }
    const double scale = length / distance.back();
    if (distance.size() > 1)
        for (double& d : distance) d *= scale;
    distance.back() = length;
    return distance;
}

}  // namespace

std::vector<double> graded_line(double low, double high, double fine, const scene::PanelMesh& mesh) {
    const auto below = fine > low ? one_side(fine - low, mesh) : std::vector<double>{0};
    const auto above = fine < high ? one_side(high - fine, mesh) : std::vector<double>{0};
    std::vector<double> line;
    line.reserve(below.size() + above.size() - 1);
    for (auto d = below.rbegin(); d != below.rend(); ++d) line.push_back(fine - *d);
    for (auto d = above.begin() + 1; d != above.end(); ++d) line.push_back(fine + *d);
    line.front() = low;
    line.back() = high;
    return line;
}

}  // namespace weavefront::mesh
