#include "weavefront/contact/frame.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

FrameShape::FrameShape(const scene::Frame& frame, double top, double offset)
    : half_opening_(frame.half_opening),
      radius_(frame.radius),
      top_(top - offset),
      edge_(frame.edge_radius + offset) {
    for (auto* half : {&half_opening_[0], &half_opening_[1], &radius_})
        if (*half) **half -= offset;
}

Vec3 FrameShape::away_from_axis(const Vec3& point) {
    const double distance = std::sqrt(point.x() * point.x() + point.y() * point.y());
    return distance > 0 ? Vec3(point.x() / distance, point.y() / distance, 0) : Vec3(Vec3::UnitX());
}

std::optional<body::Depth> FrameShape::depth_in_bar(const Vec3& point, const Vec3& outward) const {
    const auto& half = radius_ ? radius_ : half_opening_[outward.x() != 0 ? 0 : 1];
    if (!half) return std::nullopt;
    const double below_top = point.z() - top_, behind_side = outward.dot(point) - *half;
    if (below_top <= 0 || behind_side <= 0) return std::nullopt;
    const Vec3 inward = Vec3::Zero() - outward, up = -Vec3::UnitZ();
    body::Depth found{std::min(below_top, behind_side), behind_side < below_top ? inward : up};
    const double into_side = edge_ - behind_side, into_top = edge_ - below_top;
    if (into_side > 0 && into_top > 0) {
        const double distance = std::sqrt(into_side * into_side + into_top * into_top);
        found = {edge_ - distance, into_side / distance * inward + into_top / distance * up};
    }
    return found.depth > 0 ? std::optional(found) : std::nullopt;
}

std::optional<body::Depth> FrameShape::depth(const Vec3& point) const {
    if (radius_) return depth_in_bar(point, away_from_axis(point));
    std::optional<body::Depth> deepest;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const auto found = depth_in_bar(point, (point[axis] < 0 ? -1 : 1) * Vec3::Unit(axis));
        if (found && (!deepest || found->depth > deepest->depth)) deepest = found;
    }
    return deepest;
}

bool FrameShape::may_touch(const Vec3& low, const Vec3& high) const {
    if (high.z() <= top_) return false;
    std::array<double, 2> farthest;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        farthest[axis] = std::max(high[i], -low[i]);
        if (half_opening_[axis] && farthest[axis] > *half_opening_[axis]) return true;
    }
    return radius_ && farthest[0] * farthest[0] + farthest[1] * farthest[1] > *radius_ * *radius_;
}

}  // namespace weavefront::contact
