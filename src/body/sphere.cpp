#include "sphere.hpp"

#include <numbers>

#include "meridian.hpp"

namespace weavefront::body {

std::optional<Depth> Sphere::depth(const Vec3& point, double offset, Face& /*face*/) const {
    const double radius = diameter_ / 2 + offset;
    const Vec3 from_centre = point - Vec3(0, 0, offset - radius);
    const double distance = from_centre.norm();
    if (distance >= radius) return std::nullopt;
    const Vec3 normal = distance > 0 ? Vec3(from_centre / distance) : Vec3(0, 0, 1);
    return Depth{radius - distance, normal, radius};
}

Bounds Sphere::bounds() const {
    const double radius = diameter_ / 2;
    return {{-radius, -radius, -diameter_}, {radius, radius, 0}};
}

MassProperties Sphere::mass_properties() const {
    const double radius = diameter_ / 2;
    return {std::numbers::pi / 6 * diameter_ * diameter_ * diameter_,
            {0, 0, -radius},
            0.4 * radius * radius * Eigen::Matrix3d::Identity()};
}

double Sphere::presented_area(const Vec3& /*direction*/) const {
    return std::numbers::pi / 4 * diameter_ * diameter_;
}

Outline Sphere::outline() const {
    constexpr double quarter_turn = std::numbers::pi / 2;
    const double radius = diameter_ / 2;
    return revolve({arc({0, -radius}, radius, 0, quarter_turn),
                    arc({0, -radius}, radius, quarter_turn, 2 * quarter_turn)});
}

}  // namespace weavefront::body
