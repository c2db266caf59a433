#include "revolved_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "shadow.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::body {

namespace {

using Eigen::Vector2d;

constexpr double pi = std::numbers::pi;

Vector2d vector(const MeridianPoint& point) { return {point.r, point.z}; }

/// Direction of a segment along the meridian at its start or end.
Vector2d direction(const Segment& segment, bool at_end) {
    if (!segment.arc) return (vector(segment.to) - vector(segment.from)).normalized();
    const double angle = at_end ? segment.arc->to : segment.arc->from,
                 sign = segment.arc->to > segment.arc->from ? 1 : -1;
    return {sign * scene::cosine(angle), -sign * scene::sine(angle)};
}

/// Outward normal of a direction along the meridian.
Vector2d outward(const Vector2d& along) { return {-along.y(), along.x()}; }

/// Smaller radius of curvature of a surface of revolution; 0: flat. @param along of the meridian; infinite:
/// line
double smaller_radius(double along, double r, const Vector2d& normal) {
    constexpr double flat = 1e-12;
    const double around = normal.x() > flat ? r / normal.x() : std::numeric_limits<double>::infinity();
    const double smaller = std::min(along, around);
    return std::isfinite(smaller) ? smaller : 0;
}

/// Extreme value of a coordinate of a segment: `axis` 0 for r, 1 for z; `sign` 1 for the largest.
double extreme(const Segment& segment, int axis, double sign) {
    double most = std::max(sign * vector(segment.from)[axis], sign * vector(segment.to)[axis]);
    if (!segment.arc) return sign * most;
    const auto& arc = *segment.arc;
    const auto [low, high] = std::minmax(arc.from, arc.to);
    const double at = axis == 0 ? sign * pi / 2 : sign > 0 ? 0 : pi;
    for (const double turn : {-2 * pi, 0.0, 2 * pi})
        if (at + turn > low && at + turn < high)
            most = std::max(most, sign * vector(arc.centre)[axis] + arc.radius);
    return sign * most;
}

}  // namespace

RevolvedProfile::Sector RevolvedProfile::sector_of(const Segment& segment) {
    if (!segment.arc) return {};
    const double middle = (segment.arc->from + segment.arc->to) / 2,
                 half = std::abs(segment.arc->to - segment.arc->from) / 2;
    return {{scene::sine(middle), scene::cosine(middle)}, scene::cosine(half)};
}

RevolvedProfile::RevolvedProfile(Meridian meridian) : meridian_(std::move(meridian)) {
    radius_ = front_ = 0, rear_ = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < meridian_.size(); ++i) {
        const auto& segment = meridian_[i];
        const Vector2d out = direction(segment, false);
        // Across the axis the meridian goes on as its mirror image.
        const Vector2d in = i == 0 ? Vector2d(out.x(), -out.y()) : direction(meridian_[i - 1], true);
        joints_.push_back({vector(segment.from), in, out, in.y() * out.x() - in.x() * out.y()});
        sectors_.push_back(sector_of(segment));
        radius_ = std::max(radius_, extreme(segment, 0, 1));
        front_ = std::max(front_, extreme(segment, 1, 1));
        rear_ = std::min(rear_, extreme(segment, 1, -1));
    }
    const Vector2d in = direction(meridian_.back(), true), out(in.x(), -in.y());
    joints_.push_back({vector(meridian_.back().to), in, out, in.y() * out.x() - in.x() * out.y()});
}

Bounds RevolvedProfile::bounds() const { return {{-radius_, -radius_, rear_}, {radius_, radius_, front_}}; }

double RevolvedProfile::presented_area(const Vec3& direction) const {
    if (direction.x() == 0 && direction.y() == 0) return pi * radius_ * radius_;
    return shadow_area(revolve(meridian_, fine), direction);
}

RevolvedProfile::Seen RevolvedProfile::seen(std::size_t segment, const Point& point, double offset) const {
    const auto& [from, to, arc] = meridian_[segment];
    if (!arc) {
        const Vector2d way = vector(to) - vector(from);
        const double length = way.norm();
        const Vector2d along = way / length, normal = outward(along);
        const double at = (point - vector(from)).dot(along);
        return {(point - vector(from)).dot(normal), normal,
                smaller_radius(std::numeric_limits<double>::infinity(), point.x(), normal), at<0, at> length};
    }
    const Vector2d from_centre = point - vector(arc->centre);
    const auto& [middle, cosine_of_half] = sectors_[segment];
    const double distance = from_centre.norm(), sign = arc->to > arc->from ? 1 : -1;
    // At the centre every direction is as good.
    const Vector2d direction = distance > 0 ? Vector2d(from_centre / distance) : middle;
    const bool within = direction.dot(middle) >= cosine_of_half,
               in_second_half = sign * (direction.x() * middle.y() - direction.y() * middle.x()) >= 0;
    const double along = sign > 0 ? arc->radius + offset : std::numeric_limits<double>::infinity();
    const Vector2d normal = sign * direction;
    return {sign * (distance - arc->radius), normal, smaller_radius(along, point.x(), normal),
            !within && !in_second_half, !within && in_second_half};
}

std::size_t RevolvedProfile::nearest(const Point& point, double& height) const {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < meridian_.size(); ++i) {
        const auto at = seen(i, point, 0);
        double signed_distance = at.height;
        if (at.before || at.beyond) {
            const double to_start = (point - joints_[i].at).norm(),
                         to_end = (point - joints_[i + 1].at).norm();
            const auto& joint = to_start <= to_end ? joints_[i] : joints_[i + 1];
            signed_distance = (joint.turn >= 0 ? 1 : -1) * std::min(to_start, to_end);
        }
        if (std::abs(signed_distance) >= least) continue;
        least = std::abs(signed_distance);
        height = signed_distance;
        nearest = i;
    }
    return nearest;
}

RevolvedProfile::Found RevolvedProfile::at_edge(const Joint& joint, const Point& point, double offset) const {
    const double sign = joint.turn >= 0 ? 1 : -1, distance = (point - joint.at).norm();
    const Vector2d normal = distance > 0 ? Vector2d(sign / distance * (point - joint.at))
                                         : Vector2d((outward(joint.in) + outward(joint.out)).normalized());
    return {offset - sign * distance, normal, 0};
}

std::size_t RevolvedProfile::deeper_neighbour(std::size_t segment, double height, const Point& point,
                                              double offset) const {
    std::size_t deepest = segment;
    const auto look = [&](std::size_t joint, std::size_t neighbour) {
        if (joints_[joint].turn >= 0) return;
        const auto other = seen(neighbour, point, offset);
        if (other.before || other.beyond || other.height >= height) return;
        deepest = neighbour;
        height = other.height;
    };
    if (height <= 0) return segment;  // behind the face: no other face lies in front of it there
    if (segment > 0) look(segment, segment - 1);
    if (segment + 1 < meridian_.size()) look(segment + 1, segment + 1);
    return deepest;
}

RevolvedProfile::Found RevolvedProfile::follow(const Point& point, double offset,
                                               std::size_t& segment) const {
    Seen at = seen(segment, point, offset);
    for (std::size_t steps = 0; steps <= meridian_.size(); ++steps) {
        const bool forward = at.beyond;
        if (!forward && !at.before) break;
        const std::size_t edge = forward ? segment + 1 : segment;
        const auto& joint = joints_[edge];
        if (edge == 0 || edge == meridian_.size()) return at_edge(joint, point, offset);
        const std::size_t next = forward ? segment + 1 : segment - 1;
        const Seen other = seen(next, point, offset);
        constexpr double smooth = 1e-9;
        const bool is_sharp = std::abs(joint.turn) > smooth;
        if (is_sharp && (forward ? other.before : other.beyond)) return at_edge(joint, point, offset);
        const double sign = forward ? 1 : -1;
        const Vector2d way = sign * (forward ? joint.in : joint.out),
                       next_way = sign * (forward ? joint.out : joint.in), from_edge = point - joint.at;
        const double past = from_edge.dot(way), along_next = from_edge.dot(next_way),
                     width = offset * (way.dot(next_way) > 0 ? joint.turn : 1);
        // Beside the edge the share of the next face is 1 at its rounded end, and behind the width.
        if (joint.turn > smooth && past > 0 && past < width && along_next > 0) {
            const double share = std::max(past / width, past / (past + along_next));
            const Vector2d normal = outward(forward ? joint.in : joint.out);
            return {(1 - share) * (offset - from_edge.dot(normal)) + share * (offset - other.height),
                    ((1 - share) * normal + share * other.normal).normalized(),
                    (1 - share) * at.radius + share * other.radius};
        }
        segment = next;
        at = other;
    }
    return {offset - at.height, at.normal, at.radius};
}

std::optional<Depth> RevolvedProfile::depth(const Vec3& point, double offset, Face& face) const {
    const double r = std::sqrt(point.x() * point.x() + point.y() * point.y());
    const Point in_plane(r, point.z());
    double height = 0;
    const std::size_t closest = nearest(in_plane, height);
    if (face < 1 || height >= offset) face = static_cast<Face>(closest) + 1;
    if (height >= offset) return std::nullopt;
    auto segment = static_cast<std::size_t>(face - 1);
    segment = deeper_neighbour(segment, seen(segment, in_plane, offset).height, in_plane, offset);
    Found found = follow(in_plane, offset, segment);
    if (found.depth <= 0) {  // the face lies elsewhere: on the other side of a hollow
        segment = closest;
        found = follow(in_plane, offset, segment);
        found.depth = offset - height;
    }
    face = static_cast<Face>(segment) + 1;
    const Vec3 radial = r > 0 ? Vec3(point.x() / r, point.y() / r, 0) : Vec3(1, 0, 0);
    return Depth{found.depth, found.normal.x() * radial + Vec3(0, 0, found.normal.y()), found.radius};
}

}  // namespace weavefront::body
