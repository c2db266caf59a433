#include "shadow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace weavefront::body {

namespace {

using Interval = std::pair<double, double>;
using Eigen::Vector2d;

constexpr int stripes = 2000;

/// Height and thickness of the stripes.
struct Stripes {
    double low, width;

    [[nodiscard]] double middle(int stripe) const { return low + (stripe + 0.5) * width; }
    [[nodiscard]] int first_above(double height) const {
        return std::clamp(static_cast<int>(std::ceil((height - low) / width - 0.5)), 0, stripes);
    }
};

/// Adds the part of each stripe that a triangle covers.
void add_triangle(const std::array<Vector2d, 3>& corners, const Stripes& of,
                  std::vector<std::vector<Interval>>& covered) {
    const auto [low, high] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    for (int s = of.first_above(low); s < of.first_above(high); ++s) {
        const double height = of.middle(s);
        Interval interval{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector2d &a = corners[c], &b = corners[(c + 1) % 3];
            if ((a.y() > height) == (b.y() > height)) continue;
            const double x = a.x() + (b.x() - a.x()) * (height - a.y()) / (b.y() - a.y());
            interval = {std::min(interval.first, x), std::max(interval.second, x)};
        }
        if (interval.first < interval.second) covered[static_cast<std::size_t>(s)].push_back(interval);
    }
}

double length_of_union(std::vector<Interval>& intervals) {
    std::ranges::sort(intervals);
    double length = 0, end = -std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : intervals) {
        length += std::max(to - std::max(from, end), 0.0);
        end = std::max(end, to);
    }
    return length;
}

}  // namespace

double shadow_area(const Outline& outline, const Vec3& direction) {
    const Vec3 along = direction.normalized(), across = along.unitOrthogonal(), up = along.cross(across);
    std::vector<Vector2d> points;
    Stripes of{std::numeric_limits<double>::infinity(), 0};
    double high = -of.low;
    for (const auto& point : outline.points) {
        points.emplace_back(point.dot(across), point.dot(up));
        of.low = std::min(of.low, points.back().y());
        high = std::max(high, points.back().y());
    }
    of.width = (high - of.low) / stripes;
    std::vector<std::vector<Interval>> covered(stripes);
    const auto at = [&](std::int64_t point) { return points[static_cast<std::size_t>(point)]; };
    for (const auto& [a, b, c, d] : outline.quads) {
        add_triangle({at(a), at(b), at(c)}, of, covered);
        if (c != d) add_triangle({at(a), at(c), at(d)}, of, covered);
    }
    double area = 0;
    for (auto& intervals : covered) area += length_of_union(intervals) * of.width;
    return area;
}

}  // namespace weavefront::body
