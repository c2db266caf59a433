#include "weavefront/body/shape.hpp"

#include "cylinder.hpp"
#include "shapes.hpp"
#include "sphere.hpp"

namespace weavefront::body {

std::unique_ptr<const Shape> make_shape(const scene::Projectile& projectile) {
    using scene::Shape;
    switch (projectile.shape) {
        case Shape::sphere:
            return std::make_unique<Sphere>(projectile.diameter);
        case Shape::cylinder:
            break;
        case Shape::hemisphere:
            return make_hemisphere(projectile);
        case Shape::cone:
            return make_cone(projectile);
        case Shape::truncated_cone:
            return make_truncated_cone(projectile);
        case Shape::ogive:
            return make_ogive(projectile);
        case Shape::profile:
            return make_profile(projectile);
        case Shape::box:
            return make_box(projectile);
        case Shape::ring_segment:
            return make_ring_segment(projectile);
        case Shape::fsp:
            return make_fsp(projectile);
        case Shape::mesh:
            return make_mesh(projectile);
    }
    return std::make_unique<Cylinder>(projectile.diameter, projectile.edge_radius, projectile.length);
}

}  // namespace weavefront::body
