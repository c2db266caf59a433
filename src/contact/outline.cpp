#include "weavefront/contact/outline.hpp"

#include <algorithm>

namespace weavefront::contact {

Outline::Outline(const std::array<Vec3, 4>& corners)
    : corners_(corners),
      low_(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2].cwiseMin(corners[3]))),
      high_(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2].cwiseMax(corners[3]))) {}

Vec3 Outline::normal() const { return (corners_[2] - corners_[0]).cross(corners_[3] - corners_[1]).normalized(); }

double Outline::distance_to(const Outline& other, double enough) const {
    double gap = (other.low_ - high_).cwiseMax(low_ - other.high_).maxCoeff();
    if (gap < enough) gap = std::max(gap, gap_along(normal(), other));
    if (gap < enough) gap = std::max(gap, other.gap_along(other.normal(), *this));
    if (gap < enough) gap = std::max(gap, gap_along(between_nearest_corners(other), other));
    return gap;
}

Vec3 Outline::between_nearest_corners(const Outline& other) const {
    Vec3 shortest = other.corners_[0] - corners_[0];
    for (const auto& to : other.corners_)
        for (const auto& from : corners_)
            if ((to - from).squaredNorm() < shortest.squaredNorm()) shortest = to - from;
    return shortest.normalized();
}

double Outline::gap_along(const Vec3& axis, const Outline& other) const {
    double back = corners_[0].dot(axis), front = back, nearest = other.corners_[0].dot(axis), farthest = nearest;
    for (std::size_t a = 1; a < 4; ++a) {
        const double here = corners_[a].dot(axis), there = other.corners_[a].dot(axis);
        back = std::min(back, here), front = std::max(front, here);
        nearest = std::min(nearest, there), farthest = std::max(farthest, there);
    }
    return std::max(nearest - front, back - farthest);
}

}  // namespace weavefront::contact
