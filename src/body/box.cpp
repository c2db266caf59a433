#include "shapes.hpp"
#include "triangulated_surface.hpp"

namespace weavefront::body {

ShapePointer make_box(const scene::Projectile& projectile) {
    const auto& [x, y, z] = projectile.size;
    const std::vector<MeridianPoint> section{{x / 2, 0}, {-x / 2, 0}, {-x / 2, -z}, {x / 2, -z}};
    return std::make_unique<TriangulatedSurface>(extrude({section}, y));
}

}  // namespace weavefront::body
