#include "cylinder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meridian.hpp"

namespace weavefront::body {

namespace {

/// The inflated cylinder, m.
struct Inflated {
    double radius, edge, front, rear;

    /// Distance along z of the rounded face behind its plane at a radius, m.
    [[nodiscard]] double rim_drop(double at) const {
        const double on_arc = at - (radius - edge);
        return on_arc <= 0 ? 0 : edge - std::sqrt(std::max(edge * edge - on_arc * on_arc, 0.0));
    }

    /// Depth below the face looking along the axis; `direction` +1 for the front, -1 for the rear.
    [[nodiscard]] Depth face_depth(const Vec3& point, double at, double axial, double direction) const {
        const double on_arc = std::max(at - (radius - edge), 0.0);
        if (on_arc == 0) return {axial, {0, 0, direction}};
        const double outward = std::min(on_arc / edge, 1.0), along = std::sqrt(1 - outward * outward);
        // The axial depth projected on the normal vanishes at the outer radius.
        return {axial * along, {outward * point.x() / at, outward * point.y() / at, direction * along}};
    }

    [[nodiscard]] Depth side_depth(const Vec3& point, double at) const {
        const Vec3 radial = at > 0 ? Vec3(point.x() / at, point.y() / at, 0) : Vec3(1, 0, 0);
        const double into_rim = std::max({point.z() - (front - edge), (rear + edge) - point.z(), 0.0});
        const double on_arc = at - (radius - edge);
        if (into_rim == 0 || on_arc <= 0) return {radius - at, radial};
        const double distance = std::sqrt(into_rim * into_rim + on_arc * on_arc),
                     upwards = point.z() > (front + rear) / 2 ? 1 : -1;
        return {edge - distance, on_arc / distance * radial + Vec3(0, 0, upwards * into_rim / distance)};
    }
};

/// Perimeter of the shadow of a disk. @param cosine of the angle between the light and the axis of the disk
double shadow_perimeter(double radius, double cosine) {
    return 4 * radius * std::comp_ellint_2(std::sqrt(std::max(1 - cosine * cosine, 0.0)));
}

}  // namespace

std::optional<Depth> Cylinder::depth(const Vec3& point, double offset, Face& face) const {
    const Inflated shape{diameter_ / 2 + offset, edge_radius_ + offset, offset, -length_ - offset};
    const double at = std::sqrt(point.x() * point.x() + point.y() * point.y());
    if (at >= shape.radius) {
        face = none;
        return std::nullopt;
    }
    const double drop = shape.rim_drop(at);
    const double below_front = shape.front - drop - point.z(), above_rear = point.z() - (shape.rear + drop);
    if (below_front <= 0 || above_rear <= 0) {
        face = below_front <= 0 ? front : rear;  // outside, ahead of the face that the point will enter
        return std::nullopt;
    }
    const auto at_front = shape.face_depth(point, at, below_front, 1),
               at_rear = shape.face_depth(point, at, above_rear, -1);
    const auto lateral = shape.side_depth(point, at);
    if (face == none) {
        face = side;
        if (at_front.depth < lateral.depth) face = front;
        if (at_rear.depth < std::min(lateral.depth, at_front.depth)) face = rear;
    }
    const auto& chosen = face == front ? at_front : face == rear ? at_rear : lateral;
    return chosen.depth > 0 ? std::optional(chosen) : std::nullopt;
}

Bounds Cylinder::bounds() const {
    const double radius = diameter_ / 2;
    return {{-radius, -radius, -length_}, {radius, radius, 0}};
}

Meridian Cylinder::meridian() const {
    constexpr double quarter_turn = std::numbers::pi / 2;
    const double radius = diameter_ / 2, edge = edge_radius_;
    return {line({0, 0}, {radius - edge, 0}), arc({radius - edge, -edge}, edge, 0, quarter_turn),
            line({radius, -edge}, {radius, edge - length_}),
            arc({radius - edge, edge - length_}, edge, quarter_turn, 2 * quarter_turn),
            line({radius - edge, -length_}, {0, -length_})};
}

MassProperties Cylinder::mass_properties() const { return mass_of_revolution(meridian()); }

double Cylinder::presented_area(const Vec3& direction) const {
    // The cylinder is the sum of a smaller sharp one and a ball. So is its shadow, of a smaller one and a
    // disk.
    constexpr double pi = std::numbers::pi;
    const double cosine = std::abs(direction.z()) / direction.norm(),
                 sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
    const double radius = diameter_ / 2 - edge_radius_, height = (length_ - 2 * edge_radius_) * sine;
    const double area = pi * radius * radius * cosine + 2 * radius * height,
                 perimeter = shadow_perimeter(radius, cosine) + 2 * height;
    return area + perimeter * edge_radius_ + pi * edge_radius_ * edge_radius_;
}

Outline Cylinder::outline() const { return revolve(meridian()); }

}  // namespace weavefront::body
