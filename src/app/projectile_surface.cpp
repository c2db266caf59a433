#include "projectile_surface.hpp"

#include "weavefront/body/shape.hpp"

namespace weavefront::app {

ProjectileSurfaces projectile_surfaces(const scene::Scene& scene) {
    ProjectileSurfaces surfaces;
    for (const auto& projectile : scene.projectiles) {
        const auto outline = body::make_shape(projectile)->outline();
        const auto before = static_cast<std::int64_t>(surfaces.all.points.size());
        for (const auto& point : outline.points)
            surfaces.all.points.push_back({point.x(), point.y(), point.z()});
        for (auto quad : outline.quads) {
            for (auto& corner : quad) corner += before;
            surfaces.all.quads.push_back(quad);
        }
        surfaces.points.push_back(outline.points.size());
        surfaces.quads.push_back(outline.quads.size());
    }
    return surfaces;
}

}  // namespace weavefront::app
