#pragma once
/// @file
/// Pressure of a rigid body on one facet.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ranges>
#include <span>
#include <vector>

#include "weavefront/contact/contact_forces.hpp"
#include "weavefront/contact/depth.hpp"
#include "weavefront/contact/facet_memory.hpp"
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
    double thickness;  ///< of the ply, m
    Master body;
    Vec3 away;                    ///< from the body to the facet, of any length
    Vec3 body_velocity{0, 0, 0};  ///< m/s
};

/// Normals of a ply at the corners of a facet, of any length; none: the body pushes along its own normal, as in node-to-surface contact.
using PlyNormals = std::optional<std::array<Vec3, 4>>;

/// Direction in which a body without friction pushes a point of a ply: along the normal of the ply, so that it does not pull on the yarns.
/// The normal of the body does where the two differ, as they do over an edge that presses into the ply: tensions would then not be handed
/// on from one side of the edge to the other. A ply seen at more than 60 deg, as at the rim of a hole, leaves along the normal of the body.
inline Vec3 push_direction(const Vec3& of_ply, const Vec3& of_body) {
    constexpr double cos_60 = 0.5;
    const double length = of_ply.norm(), facing = of_ply.dot(of_body);
    if (!(std::abs(facing) > cos_60 * length)) return of_body;
    return (facing > 0 ? 1 : -1) / length * of_ply;
}

/// What a facet remembers of a rigid body. `Point` has a member `penetration`.
template <class Point>
struct RigidMemory {
    std::vector<Point> points;  ///< none away from the body
    double reserve = 0;         ///< see PenaltyLaw, J/m2
    double opened = 0;          ///< of the facet while none of its points presses: see PenaltyLaw, m
};

/// Forgets the points of a facet, which is away from the body.
template <class Point>
void forget_points(FacetMemory<RigidMemory<Point>>& memories, std::int32_t facet) {
    auto* memory = memories.find(facet);
    if (!memory) return;
    if (memory->reserve == 0)
        memories.forget(facet);
    else
        *memory = {.points = {}, .reserve = memory->reserve};
}

/// Rules of the initial shapes of a surface's owned facets. @param x initial positions, m
inline mesh::Repeated<std::int32_t> rules_for(Quadrature& quadrature, const Surface& surface, std::span<const Vec3> x) {
    mesh::Repeated<std::int32_t> rules;
    rules.period.reserve(surface.areas.period.size());
    for (std::size_t f = 0; f < surface.areas.period.size(); ++f)
        rules.period.push_back(quadrature.rule_for(corners_of(surface.facets[f].nodes, x)));
    return rules;
}

/// Follows by how much a facet without points in the body has opened from it.
template <class Point>
void follow_opening(const RigidPair& pair, std::span<const Vec3> x, std::span<const Vec3> v, double dt, RigidMemory<Point>& memory) {
    if (pair.law.is_elastic()) return;
    const auto corners = corners_of(pair.facet.nodes, x);
    const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
    const Vec3 relative = pair.body_velocity - centre_of(corners_of(pair.facet.nodes, v));
    const double closing = (normal.dot(pair.away) < 0 ? -1 : 1) * relative.dot(normal);
    memory.opened = std::clamp(memory.opened - closing * dt, 0.0, pair.law.most_opened(pair.thickness));
}

/// By how much the points of a facet that press have opened, in the mean, m; none presses: nothing.
template <class Point>
std::optional<double> mean_opening(const QuadratureRule& rule, const std::vector<Point>& points) {
    double sum = 0, shares = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!(points[p].penetration.present() > 0)) continue;
        const double share = rule[p / batch_width].share[p % batch_width];
        sum += share * points[p].penetration.opened;
        shares += share;
    }
    return shares > 0 ? std::optional(sum / shares) : std::nullopt;
}

/// The depth of a point that has left the body, which then tells no normal.
/// @param of_ply of any length; zero: none
inline Depth left_behind(const Vec3& of_ply, const Vec3& away) {
    const Vec3& along = of_ply == Vec3::Zero() ? away : of_ply;
    return {0, (along.dot(away) < 0 ? -1 : 1) * along.normalized()};
}

/// Integrates the pressure over the points of a facet.
/// @param x, v    positions and velocities of the nodes, m, m/s
/// @param dt      the last step, s
/// @param sliding_share see Surroundings
/// @param depth   function of a position and of the memory of the point: its depth in the body, or nothing
/// @param normals function that gives the PlyNormals of the facet, called when the first point is in the body
/// @param forces  what the facet does is appended
template <class Point, class DepthOf, class NormalsOf>
void press(const RigidPair& pair, std::span<const Vec3> x, std::span<const Vec3> v, double dt, double sliding_share,
           RigidMemory<Point>& memory, DepthOf depth, NormalsOf normals, ContactForces& forces) {
    auto& points = memory.points;
    if (points.empty()) points.resize(pair.rule.size() * batch_width);
    const auto corners = corners_of(pair.facet.nodes, x), velocities = corners_of(pair.facet.nodes, v);
    PairForce sum(pair.facet.nodes, pair.body);
    SlidingEnergy sliding;
    std::optional<PlyNormals> of_ply;
    const auto opened = mean_opening(pair.rule, points);
    const Surroundings around{memory.reserve, opened.value_or(memory.opened), sliding_share};
    bool presses = false;
    for (std::size_t b = 0; b < pair.rule.size(); ++b) {
        const auto& batch = pair.rule[b];
        const auto position = interpolate(corners, batch.N);
        for (std::size_t i = 0; i < batch.count; ++i) {
            auto& point = points[b * batch_width + i];
            const std::optional<Depth> found = depth(Vec3(position.x[i], position.y[i], position.z[i]), point);
            if (!found && point.penetration.overlap == 0) continue;
            if (!of_ply) of_ply = normals();
            const Vec3 ply_normal = *of_ply ? at_point(**of_ply, batch.N, i) : Vec3::Zero();
            const auto at = found ? *found : left_behind(ply_normal, pair.away);
            const Vec3 direction = push_direction(ply_normal, at.normal);
            const Vec3 relative = pair.body_velocity - at_point(velocities, batch.N, i);
            const double closing = relative.dot(direction);
            // The depth is a distance: it changes by no more than the sides move.
            const RelativeMotion motion{closing, closing * direction.dot(at.normal), relative.norm()};
            const auto pressed = pair.law.advance(point.penetration, at.depth, motion, dt, batch.share[i], around);
            presses = presses || point.penetration.present() > 0;
            memory.reserve += pressed.gained;
            sliding.add(pressed.sliding);
            sum.add(pressed.pressure * pair.area * batch.share[i] * direction, batch.N, i);
        }
    }
    if (presses || opened)
        memory.opened = 0;
    else
        follow_opening(pair, x, v, dt, memory);
    if (sum.total != Vec3::Zero()) forces.pairs.push_back(sum);
    if (sliding.is_any()) forces.sliding.push_back(sliding.times(pair.area));
}

/// Appends the memory of a facet for another rank: its reserve (J/m2), its opening (m) and the penetrations of its points.
template <class Point>
void save_points(const RigidMemory<Point>& memory, std::vector<double>& record) {
    record.insert(record.end(), {memory.reserve, memory.opened, static_cast<double>(memory.points.size())});
    for (const auto& [overlap, ignored, opened] : memory.points | std::views::transform(&Point::penetration))
        record.insert(record.end(), {overlap, ignored, opened});
}

/// Takes up what another rank remembered of a facet, if anything.
template <class Point>
void keep(FacetMemory<RigidMemory<Point>>& memories, std::int32_t facet, RigidMemory<Point> memory) {
    if (memory.reserve != 0 || memory.opened != 0 || !memory.points.empty()) memories.take(facet) = std::move(memory);
}

/// Reads what save_points wrote. @return what comes after it
template <class Point>
std::span<const double> restore_points(RigidMemory<Point>& memory, std::span<const double> record) {
    auto next = record.begin();
    memory.reserve = *next++;
    memory.opened = *next++;
    memory.points.resize(static_cast<std::size_t>(*next++));
    for (auto& point : memory.points) {
        point.penetration.overlap = *next++;
        point.penetration.ignored = *next++;
        point.penetration.opened = *next++;
    }
    return {next, record.end()};
}

}  // namespace weavefront::contact
