#include "weavefront/contact/projectile.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

ProjectileShape::ProjectileShape(const scene::Projectile& projectile, double offset)
    : sphere_(projectile.shape == scene::Shape::sphere),
      radius_(projectile.diameter / 2 + offset),
      edge_(projectile.edge_radius + offset),
      front_(offset),
      rear_(-(sphere_ ? projectile.diameter : projectile.length) - offset) {}

std::optional<Depth> ProjectileShape::sphere_depth(const Vec3& point) const {
    const Vec3 from_centre = point - Vec3(0, 0, front_ - radius_);
    const double distance = from_centre.norm();
    if (distance >= radius_) return std::nullopt;
    const Vec3 normal = distance > 0 ? Vec3(from_centre / distance) : Vec3(0, 0, 1);
    return Depth{radius_ - distance, normal, radius_};
}

double ProjectileShape::rim_drop(double radius) const {
    const double on_arc = radius - (radius_ - edge_);
    return on_arc <= 0 ? 0 : edge_ - std::sqrt(std::max(edge_ * edge_ - on_arc * on_arc, 0.0));
}

Depth ProjectileShape::face_depth(const Vec3& point, double radius, double axial, double direction) const {
    const double on_arc = std::max(radius - (radius_ - edge_), 0.0);
    if (on_arc == 0) return {axial, {0, 0, direction}};
    const double outward = std::min(on_arc / edge_, 1.0), along = std::sqrt(1 - outward * outward);
    // The axial depth projected on the normal vanishes at the outer radius.
    return {axial * along, {outward * point.x() / radius, outward * point.y() / radius, direction * along}};
}

Depth ProjectileShape::side_depth(const Vec3& point, double radius) const {
    const Vec3 radial = radius > 0 ? Vec3(point.x() / radius, point.y() / radius, 0) : Vec3(1, 0, 0);
    const double into_rim = std::max({point.z() - (front_ - edge_), (rear_ + edge_) - point.z(), 0.0});
    const double on_arc = radius - (radius_ - edge_);
    if (into_rim == 0 || on_arc <= 0) return {radius_ - radius, radial};
    const double distance = std::sqrt(into_rim * into_rim + on_arc * on_arc),
                 upwards = point.z() > (front_ + rear_) / 2 ? 1 : -1;
    return {edge_ - distance, on_arc / distance * radial + Vec3(0, 0, upwards * into_rim / distance)};
}

std::optional<Depth> ProjectileShape::depth(const Vec3& point, Side& side) const {
    if (sphere_) return sphere_depth(point);
    const double radius = std::sqrt(point.x() * point.x() + point.y() * point.y());
    if (radius >= radius_) {
        side = Side::none;
        return std::nullopt;
    }
    const double drop = rim_drop(radius);
    const double below_front = front_ - drop - point.z(), above_rear = point.z() - (rear_ + drop);
    if (below_front <= 0 || above_rear <= 0) {
        side = below_front <= 0
                   ? Side::front
                   : Side::rear;  // outside, ahead of this face, through which the point will enter
        return std::nullopt;
    }
    const auto front = face_depth(point, radius, below_front, 1),
               rear = face_depth(point, radius, above_rear, -1);
    const auto lateral = side_depth(point, radius);
    if (side == Side::none) {
        side = Side::side;
        if (front.depth < lateral.depth) side = Side::front;
        if (rear.depth < std::min(lateral.depth, front.depth)) side = Side::rear;
    }
    const auto& chosen = side == Side::front ? front : side == Side::rear ? rear : lateral;
    return chosen.depth > 0 ? std::optional(chosen) : std::nullopt;
}

}  // namespace weavefront::contact
