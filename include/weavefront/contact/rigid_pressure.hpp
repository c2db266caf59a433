#pragma once
/// @file
/// Pressure of a rigid body on one facet.

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/contact/depth.hpp"
#include "weavefront/contact/penalty.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// The facet at hand and what acts on its points.
struct RigidPair {
    const Facet& facet;
    double area;  ///< initial, m2
    const QuadratureRule& rule;
    const PenaltyLaw& law;
    Master body;
    Vec3 body_velocity{0, 0, 0};  ///< m/s
    /// Of the ply at the corners, of any length; none: the body pushes along its own normal, as in node-to-surface contact.
    std::optional<std::array<Vec3, 4>> normals = {};
};

/// Direction in which a body without friction pushes a point of a ply: along the normal of the ply, so that it does not pull on the yarns.
/// The normal of the body does where the two differ, as they do over an edge that presses into the ply: tensions would then not be handed
/// on from one side of the edge to the other. A ply seen at more than 60 deg, as at the rim of a hole, leaves along the normal of the body.
inline Vec3 push_direction(const Vec3& of_ply, const Vec3& of_body) {
    constexpr double cos_60 = 0.5;
    const double length = of_ply.norm(), facing = of_ply.dot(of_body);
    if (!(std::abs(facing) > cos_60 * length)) return of_body;
    return (facing > 0 ? 1 : -1) / length * of_ply;
}

/// Integrates the pressure over the points of a facet.
/// @param x, v    positions and velocities of the nodes, m, m/s
/// @param dt      the last step, s
/// @param points  memory of the points, a `Point` with a member `penetration`
/// @param reserve of the facet: see PenaltyLaw::advance, J/m2
/// @param depth   function of a position and of the memory of the point: its depth in the body, or nothing
template <class Point, class DepthOf>
PairForce press(const RigidPair& pair, std::span<const Vec3> x, std::span<const Vec3> v, double dt, std::vector<Point>& points,
                double& reserve, DepthOf depth) {
    if (points.empty()) points.resize(pair.rule.size() * batch_width);
    const auto corners = corners_of(pair.facet.nodes, x), velocities = corners_of(pair.facet.nodes, v);
    PairForce sum(pair.facet.nodes, pair.body);
    for (std::size_t b = 0; b < pair.rule.size(); ++b) {
        const auto& batch = pair.rule[b];
        const auto position = interpolate(corners, batch.N), velocity = interpolate(velocities, batch.N);
        const auto normal = pair.normals ? interpolate(*pair.normals, batch.N) : VectorLanes{};
        for (std::size_t i = 0; i < batch.count; ++i) {
            auto& point = points[b * batch_width + i];
            const std::optional<Depth> found = depth(Vec3(position.x[i], position.y[i], position.z[i]), point);
            if (!found) {
                point.penetration = {};
                continue;
            }
            const Vec3 direction =
                pair.normals ? push_direction(Vec3(normal.x[i], normal.y[i], normal.z[i]), found->normal) : found->normal;
            const double closing = (pair.body_velocity - Vec3(velocity.x[i], velocity.y[i], velocity.z[i])).dot(direction);
            const double pressure = pair.law.advance(point.penetration, found->depth, closing, dt, batch.share[i], reserve);
            sum.add(pressure * pair.area * batch.share[i] * direction, batch.N, i);
        }
    }
    return sum;
}

/// Appends the reserve of a facet (J/m2) and the penetrations of its points, for another rank.
template <class Point>
void save_points(double reserve, const std::vector<Point>& points, std::vector<double>& record) {
    record.insert(record.end(), {reserve, static_cast<double>(points.size())});
    for (const auto& point : points) record.insert(record.end(), {point.penetration.present, point.penetration.largest});
}

/// Takes up what save_points wrote. @return what comes after it
template <class Point>
std::span<const double> restore_points(double& reserve, std::vector<Point>& points, std::span<const double> record) {
    auto next = record.begin();
    reserve = *next++;
    points.resize(static_cast<std::size_t>(*next++));
    for (auto& point : points) {
        point.penetration.present = *next++;
        point.penetration.largest = *next++;
    }
    return {next, record.end()};
}

}  // namespace weavefront::contact
