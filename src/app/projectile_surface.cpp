#include "projectile_surface.hpp"

#include <utility>

#include "weavefront/body/shape.hpp"

namespace weavefront::app {

io::Surface projectile_surface(const scene::Scene& scene) {
    io::Surface surface;
    if (!scene.projectile) return surface;
    auto outline = body::make_shape(*scene.projectile)->outline();
    for (const auto& point : outline.points) surface.points.push_back({point.x(), point.y(), point.z()});
    surface.quads = std::move(outline.quads);
    return surface;
}

}  // namespace weavefront::app
