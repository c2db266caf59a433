#include <numbers>

#include "revolved_profile.hpp"
#include "shapes.hpp"

namespace weavefront::body {

ShapePointer make_hemisphere(const scene::Projectile& projectile) {
    const double radius = projectile.diameter / 2;
    Meridian meridian{arc({0, -radius}, radius, 0, std::numbers::pi / 2)};
    add_shank(meridian, radius, projectile.length);
    return std::make_unique<RevolvedProfile>(std::move(meridian));
}

}  // namespace weavefront::body
