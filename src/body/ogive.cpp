#include <algorithm>
#include <cmath>
#include <numbers>

#include "revolved_profile.hpp"
#include "shapes.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::body {

ShapePointer make_ogive(const scene::Projectile& projectile) {
    const double radius = projectile.diameter / 2, tip = projectile.tip_radius,
                 large = projectile.caliber_radius_head * projectile.diameter, inset = large - radius;
    // The sphere touches the arc from inside: their centres are the difference of the radii apart.
    const double apart = large - tip, height = std::sqrt(std::max(apart * apart - inset * inset, 0.0));
    constexpr double rounding = 1e-6;
    const bool is_all_sphere = height <= rounding * radius;
    const double contact = is_all_sphere ? std::numbers::pi / 2 : scene::arc_tangent(inset, height);
    Meridian meridian;
    if (tip > 0) meridian.push_back(arc({0, -tip}, tip, 0, contact));
    if (!is_all_sphere)
        meridian.push_back(arc({-inset, -(height + tip)}, large, contact, std::numbers::pi / 2));
    add_shank(meridian, radius, projectile.length);
    return std::make_unique<RevolvedProfile>(std::move(meridian));
}

}  // namespace weavefront::body
