#include <cmath>
#include <numbers>

#include "revolved_profile.hpp"
#include "shapes.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::body {

ShapePointer make_cone(const scene::Projectile& projectile) {
    const double radius = projectile.diameter / 2, tip = projectile.tip_radius,
                 half = scene::arc_tangent(radius, projectile.nose_length);  // between the axis and the side
    Meridian meridian;
    double base = -projectile.nose_length;
    MeridianPoint from{0, 0};
    if (tip > 0) {
        const double cut = tip * (1 / scene::sine(half) - 1);  // of the sharp tip
        base += cut;
        meridian.push_back(arc({0, -tip}, tip, 0, std::numbers::pi / 2 - half));
        from = meridian.back().to;
    }
    constexpr double rounding = 1e-9;
    if (from.r < radius * (1 - rounding)) meridian.push_back(line(from, {radius, base}));
    add_shank(meridian, radius, projectile.length);
    return std::make_unique<RevolvedProfile>(std::move(meridian));
}

}  // namespace weavefront::body
