#include "shapes.hpp"
#include "triangulated_surface.hpp"

namespace weavefront::body {

ShapePointer make_mesh(const scene::Projectile& projectile) {
    TriangleMesh mesh;
    for (const auto& [x, y, z] : projectile.triangles.points) mesh.points.emplace_back(x, y, z);
    mesh.corners = projectile.triangles.corners;
    return std::make_unique<TriangulatedSurface>(std::move(mesh));
}

}  // namespace weavefront::body
