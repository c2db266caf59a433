#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes.hpp"
#include "triangulated_surface.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::body {

namespace {

// Chords of 2 degrees lie at most 0.00015 radii inside of their arcs.
constexpr double largest_step = std::numbers::pi / 90;

}  // namespace

ShapePointer make_ring_segment(const scene::Projectile& projectile) {
    const double outer = projectile.outer_radius, inner = outer - projectile.thickness,
                 sector = projectile.sector;
    const int steps = 2 * std::max(static_cast<int>(std::ceil(sector / largest_step / 2)), 1);
    const auto at = [&](double radius, int step) {
        const double angle = sector * (static_cast<double>(step) / steps - 0.5);
        return MeridianPoint{radius * scene::sine(angle), radius * scene::cosine(angle) - outer};
    };
    std::vector<std::vector<MeridianPoint>> parts;
    for (int i = 0; i < steps; ++i)
        parts.push_back({at(outer, i + 1), at(outer, i), at(inner, i), at(inner, i + 1)});
    return std::make_unique<TriangulatedSurface>(extrude(parts, projectile.width));
}

}  // namespace weavefront::body
