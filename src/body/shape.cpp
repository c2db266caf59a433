#include "weavefront/body/shape.hpp"

#include "cylinder.hpp"
#include "sphere.hpp"

namespace weavefront::body {

std::unique_ptr<const Shape> make_shape(const scene::Projectile& projectile) {
    if (projectile.shape == scene::Shape::sphere) return std::make_unique<Sphere>(projectile.diameter);
    return std::make_unique<Cylinder>(projectile.diameter, projectile.edge_radius, projectile.length);
}

}  // namespace weavefront::body
