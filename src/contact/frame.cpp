#include "weavefront/contact/frame.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

FrameShape::FrameShape(const scene::Frame& frame, double top, double offset)
    : half_opening_(frame.half_opening), top_(top - offset), edge_(frame.edge_radius + offset) {
    for (auto& half : half_opening_)
        if (half) *half -= offset;
}

std::optional<body::Depth> FrameShape::depth_in_bar(const Vec3& point, int axis, double outward) const {
    const auto& half = half_opening_[static_cast<std::size_t>(axis)];
    if (!half) return std::nullopt;
    const double below_top = point.z() - top_, behind_side = outward * point[axis] - *half;
    if (below_top <= 0 || behind_side <= 0) return std::nullopt;
    body::Depth found{std::min(below_top, behind_side), Vec3::Zero()};
    const double into_x = edge_ - behind_side, into_z = edge_ - below_top;
    if (into_x > 0 && into_z > 0) {
        const double distance = std::sqrt(into_x * into_x + into_z * into_z);
        found.depth = edge_ - distance;
        found.normal[axis] = -outward * into_x / distance;
        found.normal.z() = -into_z / distance;
    } else if (behind_side < below_top) {
        found.normal[axis] = -outward;
    } else {
        found.normal.z() = -1;
    }
    return found.depth > 0 ? std::optional(found) : std::nullopt;
}

std::optional<body::Depth> FrameShape::depth(const Vec3& point) const {
    std::optional<body::Depth> deepest;
    for (int axis = 0; axis < 2; ++axis) {
        const auto found = depth_in_bar(point, axis, point[axis] < 0 ? -1 : 1);
        if (found && (!deepest || found->depth > deepest->depth)) deepest = found;
    }
    return deepest;
}

bool FrameShape::may_touch(const Vec3& low, const Vec3& high) const {
    if (high.z() <= top_) return false;
    for (int axis = 0; axis < 2; ++axis) {
        const auto& half = half_opening_[static_cast<std::size_t>(axis)];
        if (half && std::max(high[axis], -low[axis]) > *half) return true;
    }
    return false;
}

}  // namespace weavefront::contact
