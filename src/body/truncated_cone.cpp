#include "revolved_profile.hpp"
#include "shapes.hpp"

namespace weavefront::body {

ShapePointer make_truncated_cone(const scene::Projectile& projectile) {
    const double radius = projectile.diameter / 2, tip = projectile.tip_diameter / 2;
    Meridian meridian{line({0, 0}, {tip, 0}), line({tip, 0}, {radius, -projectile.nose_length})};
    add_shank(meridian, radius, projectile.length);
    return std::make_unique<RevolvedProfile>(std::move(meridian));
}

}  // namespace weavefront::body
