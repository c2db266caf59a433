#include "revolved_profile.hpp"
#include "shapes.hpp"

namespace weavefront::body {

ShapePointer make_profile(const scene::Projectile& projectile) {
    const auto& points = projectile.profile;
    Meridian meridian;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        meridian.push_back(line({points[i][0], points[i][1]}, {points[i + 1][0], points[i + 1][1]}));
    return std::make_unique<RevolvedProfile>(std::move(meridian));
}

}  // namespace weavefront::body
