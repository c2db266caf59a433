#include "weavefront/contact/push_directions.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

namespace {

/// Unit normal of the ply, on the side to which the body pushes. The normal of the body where the ply is seen
/// edge-on or has no normal.
Vec3 facing(const Vec3& of_ply, const Vec3& of_body) {
    constexpr double cos_60 = 0.5;
    const double length = of_ply.norm(), along = of_ply.dot(of_body);
    if (!(std::abs(along) > cos_60 * length)) return of_body;
    return (along > 0 ? 1 : -1) / length * of_ply;
}

/// Largest curvature of the ply along an edge of the facet: turn of the normal over length, 1/m.
double largest_curvature(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& normals) {
    double largest = 0;
    for (std::size_t a = 0; a < 4; ++a) {
        const auto b = (a + 1) % 4;
        const Vec3 turn = normals[b].normalized() - normals[a].normalized();
        largest = std::max(largest, turn.norm() / (corners[b] - corners[a]).norm());
    }
    return largest;
}

}  // namespace

PushDirections::PushDirections(const PlyNormals& of_ply, const std::array<Vec3, 4>& corners, double area)
    : of_ply_(of_ply), area_(area) {
    if (of_ply_) curvature_ = largest_curvature(corners, *of_ply_);
}

Vec3 PushDirections::ply_normal(const ShapeFunctions& N, std::size_t i) const {
    return of_ply_ ? at_point(*of_ply_, N, i) : Vec3::Zero();
}

Vec3 PushDirections::at(const body::Depth& depth, const ShapeFunctions& N, std::size_t i) const {
    const Vec3 of_ply = facing(ply_normal(N, i), depth.normal);
    const bool is_resolved = depth.radius * depth.radius >= area_;
    if (!is_resolved) return of_ply;
    const double flat = std::max(1 - curvature_ * depth.radius, 0.0);
    return flat * of_ply + (1 - flat) * depth.normal;
}

body::Depth PushDirections::left_behind(const Vec3& away, const ShapeFunctions& N, std::size_t i) const {
    const Vec3 of_ply = ply_normal(N, i);
    const Vec3& along = of_ply == Vec3::Zero() ? away : of_ply;
    return {0, (along.dot(away) < 0 ? -1 : 1) * along.normalized()};
}

}  // namespace weavefront::contact
