#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes.hpp"
#include "triangulated_surface.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::body {

namespace {

constexpr double pi = std::numbers::pi;

// Of a quarter of the circumference, on each side of the face: a chord lies at most 0.0005 radii inside.
constexpr int steps = 24;

/// Angles of the rim's points in its first quarter, from the x axis. @param edge of the face, from there
std::vector<double> quarter(double edge) {
    std::vector<double> angles;
    const int first = std::max(static_cast<int>(std::round(steps * edge / (pi / 2))), 1),
              rest = std::max(steps - first, 1);
    for (int i = 0; i < first; ++i) angles.push_back(edge * i / first);
    for (int i = 0; i <= rest; ++i) angles.push_back(edge + (pi / 2 - edge) * i / rest);
    return angles;
}

/// A planar convex polygon as triangles.
void add_polygon(TriangleMesh& mesh, const std::vector<std::int32_t>& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        mesh.corners.push_back({points[0], points[i], points[i + 1]});
}

}  // namespace

ShapePointer make_fsp(const scene::Projectile& projectile) {
    const double radius = projectile.diameter / 2, half = projectile.flat_width / 2,
                 slope = scene::tangent(projectile.flat_angle);
    TriangleMesh mesh;
    std::vector<std::array<double, 2>> rim;  // counter-clockwise
    const auto angles = quarter(scene::arc_cosine(half / radius));
    const auto count = angles.size() - 1;
    for (std::size_t i = 0; i < 4 * count; ++i) {
        const auto in_quarter = i % count;
        const bool mirrored = (i / count) % 2 == 1;
        const double angle = angles[mirrored ? count - in_quarter : in_quarter],
                     c = radius * scene::cosine(angle), s = radius * scene::sine(angle);
        rim.push_back({i / count == 1 || i / count == 2 ? -c : c, i / count >= 2 ? -s : s});
    }
    const auto all = static_cast<std::int32_t>(rim.size());
    for (const auto& [x, y] : rim) mesh.points.emplace_back(x, y, -slope * std::max(std::abs(x) - half, 0.0));
    for (const auto& [x, y] : rim) mesh.points.emplace_back(x, y, -projectile.length);
    std::array<std::vector<std::int32_t>, 3> top;  // flat at +x, face, flat at -x
    std::vector<std::int32_t> bottom;
    const double rounding = 1e-9 * radius;
    for (std::int32_t i = 0; i < all; ++i) {
        // From the middle of the rim at -y, so each of the three polygons is one run of points or two.
        const auto at = (i + 3 * all / 4) % all;
        const double x = rim[static_cast<std::size_t>(at)][0];
        if (x >= half - rounding) top[0].push_back(at);
        if (std::abs(x) <= half + rounding) top[1].push_back(at);
        if (x <= -half + rounding) top[2].push_back(at);
        bottom.push_back(2 * all - 1 - i);
        const auto next = (i + 1) % all;
        mesh.corners.push_back({i, i + all, next + all});
        mesh.corners.push_back({i, next + all, next});
    }
    for (const auto& polygon : top) add_polygon(mesh, polygon);
    add_polygon(mesh, bottom);
    return std::make_unique<TriangulatedSurface>(std::move(mesh));
}

}  // namespace weavefront::body
