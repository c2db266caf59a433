#include "triangulated_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "shadow.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::body {

namespace {

using Box = Eigen::AlignedBox<double, 3>;

/// Where on a triangle a nearest point lies: its inside, an edge from corner `index`, or a corner.
enum class Feature { inside, edge, corner };
struct OnTriangle {
    Vec3 point;
    Feature feature;
    std::size_t index;
};

Vec3 along_edge(const Vec3& a, const Vec3& b, double share) { return a + share * (b - a); }

/// C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
OnTriangle nearest_on(const std::array<Vec3, 3>& corners, const Vec3& point) {
    const auto& [a, b, c] = corners;
    const Vec3 ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
                 d6 = ac.dot(cp);
    if (d1 <= 0 && d2 <= 0) return {a, Feature::corner, 0};
    if (d3 >= 0 && d4 <= d3) return {b, Feature::corner, 1};
    if (d6 >= 0 && d5 <= d6) return {c, Feature::corner, 2};
    const double of_c = d1 * d4 - d3 * d2, of_b = d5 * d2 - d1 * d6, of_a = d3 * d6 - d5 * d4;
    if (of_c <= 0 && d1 >= 0 && d3 <= 0) return {along_edge(a, b, d1 / (d1 - d3)), Feature::edge, 0};
    if (of_b <= 0 && d2 >= 0 && d6 <= 0) return {along_edge(a, c, d2 / (d2 - d6)), Feature::edge, 2};
    if (of_a <= 0 && d4 >= d3 && d5 >= d6)
        return {along_edge(b, c, (d4 - d3) / ((d4 - d3) + (d5 - d6))), Feature::edge, 1};
    const double sum = of_a + of_b + of_c;
    return {a + (of_b * ab + of_c * ac) / sum, Feature::inside, 0};
}

/// Search of the nearest triangle. The lowest number wins at equal distance, wherever the search begins.
template <class Triangles>
struct Nearest {
    const Vec3& point;
    const Triangles& triangles;
    double least = std::numeric_limits<double>::infinity();
    std::int32_t triangle = -1;
    OnTriangle place{};

    void look_at(std::int32_t number) {
        const auto found = nearest_on(triangles[static_cast<std::size_t>(number)].corners, point);
        const double distance = (found.point - point).squaredNorm();
        if (distance < least || (distance == least && number < triangle))
            least = distance, triangle = number, place = found;
    }
    /// The nearer of two boxes first: the other one then often needs no look.
    template <class Tree>
    void look_in(const Tree& tree, int node) {
        typename Tree::VolumeIterator box = nullptr, last_box = nullptr;
        typename Tree::ObjectIterator object = nullptr, last_object = nullptr;
        tree.getChildren(node, box, last_box, object, last_object);
        for (; object != last_object; ++object) look_at(*object);
        std::array<std::pair<double, int>, 2> boxes;
        std::size_t count = 0;
        for (; box != last_box; ++box)
            boxes[count++] = {tree.getVolume(*box).squaredExteriorDistance(point), *box};
        if (count == 2 && boxes[1] < boxes[0]) std::swap(boxes[0], boxes[1]);
        for (std::size_t i = 0; i < count; ++i)
            if (boxes[i].first <= least) look_in(tree, boxes[i].second);
    }
};

double angle_between(const Vec3& a, const Vec3& b) { return scene::arc_tangent(a.cross(b).norm(), a.dot(b)); }

}  // namespace

TriangleMesh extrude(const std::vector<std::vector<MeridianPoint>>& parts, double width) {
    TriangleMesh mesh;
    std::map<std::pair<double, double>, std::int32_t> numbers;  // of the points at -y; those at +y follow
    const auto number = [&](const MeridianPoint& at) {
        const auto [place, is_new] =
            numbers.try_emplace({at.r, at.z}, static_cast<std::int32_t>(mesh.points.size()));
        if (is_new)
            for (const double side : {-0.5, 0.5}) mesh.points.emplace_back(at.r, side * width, at.z);
        return place->second;
    };
    std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        mesh.corners.push_back({a, b, c});
    };
    for (const auto& part : parts) {
        std::vector<std::int32_t> at;
        for (const auto& point : part) at.push_back(number(point));
        for (std::size_t i = 0; i < at.size(); ++i) edges[{at[i], at[(i + 1) % at.size()]}] = 1;
        for (std::size_t i = 1; i + 1 < at.size(); ++i) {
            add(at[0], at[i], at[i + 1]);
            add(at[0] + 1, at[i + 1] + 1, at[i] + 1);
        }
    }
    for (const auto& [edge, once] : edges) {
        const auto& [a, b] = edge;
        if (edges.contains({b, a})) continue;  // between two parts
        add(a, b + 1, b);
        add(a, a + 1, b + 1);
    }
    return mesh;
}

TriangulatedSurface::TriangulatedSurface(TriangleMesh mesh) {
    join(mesh);
    std::vector<std::int32_t> numbers;
    std::vector<Box> boxes;
    Box all;
    for (const auto& triangle : triangles_) {
        Box box;
        for (const auto& corner : triangle.corners) box.extend(corner);
        all.extend(box);
        numbers.push_back(static_cast<std::int32_t>(numbers.size()));
        boxes.push_back(box);
    }
    tree_.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
    bounds_ = {all.min(), all.max()};
    for (const auto& point : mesh.points)
        radius_ = std::max(radius_, std::sqrt(point.x() * point.x() + point.y() * point.y()));
}

void TriangulatedSurface::join(const TriangleMesh& mesh) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> of_edge;
    std::vector<Vec3> corner_normals(mesh.points.size(), Vec3::Zero());
    for (const auto& corners : mesh.corners) {
        auto& triangle = triangles_.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            triangle.corners[c] = mesh.points[static_cast<std::size_t>(corners[c])];
            of_edge[{corners[c], corners[(c + 1) % 3]}] = static_cast<std::int32_t>(triangles_.size()) - 1;
        }
        const auto& [a, b, c] = triangle.corners;
        triangle.normal = (b - a).cross(c - a).normalized();
        for (std::size_t e = 0; e < 3; ++e) {
            const Vec3 next = triangle.corners[(e + 1) % 3] - triangle.corners[e],
                       last = triangle.corners[(e + 2) % 3] - triangle.corners[e];
            triangle.outward[e] = next.cross(triangle.normal).normalized();
            corner_normals[static_cast<std::size_t>(corners[e])] +=
                angle_between(next, last) * triangle.normal;
        }
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) {
            const auto& corners = mesh.corners[t];
            auto& triangle = triangles_[t];
            triangle.neighbours[e] = of_edge.at({corners[(e + 1) % 3], corners[e]});
            triangle.turn[e] = triangle.outward[e].dot(at(triangle.neighbours[e]).normal);
            triangle.corner_normals[e] = corner_normals[static_cast<std::size_t>(corners[e])];
        }
}

TriangulatedSurface::Closest TriangulatedSurface::closest(const Vec3& point, Face start) const {
    Nearest<std::vector<Triangle>> nearest{point, triangles_};
    if (start > 0) nearest.look_at(start - 1);
    nearest.look_in(tree_, tree_.getRootIndex());
    const auto& triangle = at(nearest.triangle);
    const auto& [place, feature, index] = nearest.place;
    Vec3 pseudo = triangle.normal;
    if (feature == Feature::edge) pseudo += at(triangle.neighbours[index]).normal;
    if (feature == Feature::corner) pseudo = triangle.corner_normals[index];
    const Vec3 away = point - place;
    const double sign = away.dot(pseudo) >= 0 ? 1 : -1, distance = std::sqrt(nearest.least);
    const Vec3 normal = feature == Feature::inside || distance == 0 ? Vec3(pseudo.normalized())
                                                                    : Vec3(sign / distance * away);
    return {sign * distance, normal, nearest.triangle};
}

Depth TriangulatedSurface::follow(const Vec3& point, double offset, const Closest& closest,
                                  std::int32_t& triangle) const {
    constexpr int most_steps = 64;
    constexpr double smooth = 1e-9;
    const Depth nearest{offset - closest.height, closest.normal};
    for (int step = 0; step < most_steps; ++step) {
        const auto& here = at(triangle);
        const double height = (point - here.corners[0]).dot(here.normal);
        std::array<double, 3> beyond{};
        for (std::size_t e = 0; e < 3; ++e) beyond[e] = (point - here.corners[e]).dot(here.outward[e]);
        const auto e = static_cast<std::size_t>(std::ranges::max_element(beyond) - beyond.begin());
        if (beyond[e] <= 0) return {offset - height, here.normal};
        const auto next = here.neighbours[e];
        const auto& there = at(next);
        const double turn = here.turn[e], cosine = here.normal.dot(there.normal);
        // In the plane of the next triangle, away from the edge.
        const Vec3 onward = cosine * here.outward[e] - turn * here.normal;
        const double along = (point - here.corners[e]).dot(onward);
        if (std::abs(turn) > smooth && along < 0) return nearest;
        const double width = offset * (cosine > 0 ? turn : 1), past = beyond[e];
        if (turn > smooth && past < width && along > 0) {
            const double share = std::max(past / width, past / (past + along)),
                         next_height = (point - there.corners[0]).dot(there.normal);
            return {offset - (1 - share) * height - share * next_height,
                    ((1 - share) * here.normal + share * there.normal).normalized()};
        }
        triangle = next;
    }
    triangle = closest.triangle;
    return nearest;
}

std::optional<Depth> TriangulatedSurface::depth(const Vec3& point, double offset, Face& face) const {
    const auto nearest = closest(point, face);
    if (face < 1 || nearest.height >= offset) face = nearest.triangle + 1;
    if (nearest.height >= offset) return std::nullopt;
    std::int32_t triangle = face - 1;
    Depth found = follow(point, offset, nearest, triangle);
    if (found.depth <= 0) {  // the triangle lies on another side of a hollow
        triangle = nearest.triangle;
        found = {offset - nearest.height, nearest.normal};
    }
    face = triangle + 1;
    return found;
}

MassProperties TriangulatedSurface::mass_properties() const {
    double volume = 0;
    Vec3 first = Vec3::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const auto& triangle : triangles_) {  // with the origin it makes a tetrahedron
        const auto& [a, b, c] = triangle.corners;
        const double six_volumes = a.dot(b.cross(c));
        const Vec3 sum = a + b + c;
        volume += six_volumes / 6;
        first += six_volumes / 24 * sum;
        second += six_volumes / 120 *
                  (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    }
    const Vec3 centroid = first / volume;
    const Eigen::Matrix3d about = second / volume - centroid * centroid.transpose();
    return {volume, centroid, about.trace() * Eigen::Matrix3d::Identity() - about};
}

double TriangulatedSurface::presented_area(const Vec3& direction) const {
    return shadow_area(outline(), direction);
}

Outline TriangulatedSurface::outline() const {
    Outline outline;
    std::map<std::array<double, 3>, std::int64_t> numbers;
    for (const auto& triangle : triangles_) {
        std::array<std::int64_t, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec3& at = triangle.corners[c];
            const auto [place, is_new] =
                numbers.try_emplace({at.x(), at.y(), at.z()}, std::ssize(outline.points));
            if (is_new) outline.points.push_back(at);
            corners[c] = place->second;
        }
        outline.quads.push_back({corners[0], corners[1], corners[2], corners[2]});
    }
    return outline;
}

}  // namespace weavefront::body
