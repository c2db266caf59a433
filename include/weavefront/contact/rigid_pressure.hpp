#pragma once
/// @file
/// Pressure of a rigid body on one facet.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/body/depth.hpp"
#include "weavefront/body/rigid_body.hpp"
#include "weavefront/contact/contact_forces.hpp"
#include "weavefront/contact/facet_memory.hpp"
#include "weavefront/contact/nodal_motion.hpp"
#include "weavefront/contact/penalty.hpp"
#include "weavefront/contact/push_directions.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// A facet and the rigid body that presses on its points.
struct RigidPair {
    const Facet& facet;
    double area;  ///< initial, m2
    const QuadratureRule& rule;
    const PenaltyLaw& law;
    double thickness;  ///< of the ply, m
    Master body;
    Vec3 away;            ///< from the body to the facet, of any length
    body::Motion motion;  ///< of the body
    bool turns = false;   ///< whether moments turn the body
};

/// State of a facet's contact with a rigid body. `Point` has a member `penetration`.
template <class Point>
struct RigidMemory {
    std::vector<Point> points;     ///< empty away from the body
    double dissipated_budget = 0;  ///< J/m2, see PenaltyLaw
};

/// The largest penetration of a facet's points, m; 0: none presses.
template <class Point>
double largest_penetration(const FacetMemory<RigidMemory<Point>>& memories, std::int32_t facet) {
    double most = 0;
    if (const auto* memory = memories.find(facet))
        for (const auto& point : memory->points) most = std::max(most, point.penetration.present());
    return most;
}

/// Drops the points of a facet away from the body. Its dissipated budget stays.
template <class Point>
void forget_points(FacetMemory<RigidMemory<Point>>& memories, std::int32_t facet) {
    auto* memory = memories.find(facet);
    if (!memory) return;
    if (memory->dissipated_budget == 0)
        memories.forget(facet);
    else
        memory->points = std::vector<Point>();
}

/// Integrates the pressure of a rigid body over the points of a facet.
/// @param nodes   positions and velocities of the nodes over the last step
/// @param sliding_share see Surroundings
/// @param depth   function of a position and the state of a point; returns the depth in the body, or none
/// @param normals function that returns the PlyNormals of the facet; called only if a point is in the body
/// @param forces  the force and sliding energy of the facet are appended
template <class Point, class DepthOf, class NormalsOf>
void press(const RigidPair& pair, const NodalMotion& nodes, double sliding_share, RigidMemory<Point>& memory,
           DepthOf depth, NormalsOf normals, ContactForces& forces) {
    auto& points = memory.points;
    if (points.empty()) points.resize(pair.rule.size() * batch_width);
    const auto corners = corners_of(pair.facet.nodes, nodes.x),
               velocities = corners_of(pair.facet.nodes, nodes.v);
    PairForce sum(pair.facet.nodes, pair.body);
    SlidingEnergy sliding;
    Vec3 moment = Vec3::Zero();
    std::optional<PushDirections> directions;
    const Surroundings around{memory.dissipated_budget, sliding_share};
    for (std::size_t b = 0; b < pair.rule.size(); ++b) {
        const auto& batch = pair.rule[b];
        const auto position = interpolate(corners, batch.N);
        for (std::size_t i = 0; i < batch.count; ++i) {
            auto& point = points[b * batch_width + i];
            const Vec3 place(position.x[i], position.y[i], position.z[i]);
            const std::optional<body::Depth> found = depth(place, point);
            if (!found && point.penetration.overlap == 0) continue;
            if (found)
                forces.deepest.include({found->depth, found->depth / pair.thickness, place, pair.facet.id});
            if (!directions) directions.emplace(normals(), corners, pair.area);
            const auto at = found ? *found : directions->left_behind(pair.away, batch.N, i);
            const Vec3 direction = directions->at(at, batch.N, i);
            const Vec3 relative = pair.motion.at(place) - at_point(velocities, batch.N, i);
            const double closing = relative.dot(direction);
            // The depth is a distance, so its rate is at most the relative speed.
            const RelativeMotion motion{closing, closing * direction.dot(at.normal), relative.norm()};
            const auto response =
                pair.law.advance(point.penetration, at.depth, motion, nodes.dt, batch.share[i], around);
            memory.dissipated_budget += response.dissipated;
            sliding.add(response.sliding);
            const Vec3 on_fabric = response.pressure * pair.area * batch.share[i] * direction;
            sum.add(on_fabric, batch.N, i);
            if (pair.turns) moment -= (place - pair.motion.centre).cross(on_fabric);
        }
    }
    if (moment != Vec3::Zero()) forces.moments.push_back(moment);
    if (sum.total != Vec3::Zero()) forces.pairs.push_back(sum);
    if (sliding.is_any()) forces.sliding.push_back(sliding.times(pair.area));
}

/// State of a facet that remembers a rigid body: its dissipated budget (J/m2) and its points, each by its own
/// `state`. A facet without either has none.
template <class Archive, class Point>
void facet_state(Archive& archive, FacetMemory<RigidMemory<Point>>& memories, std::int32_t facet) {
    auto* memory = memories.find(facet);
    const auto budgets = archive.size("dissipated_budget", memory && memory->dissipated_budget != 0 ? 1 : 0);
    const auto points = archive.size("overlap", memory ? memory->points.size() : 0);
    if (budgets + points == 0) return;
    if constexpr (Archive::reads) {
        memory = &memories.take(facet);
        memory->points.resize(points);
    }
    if (budgets > 0) archive("dissipated_budget", memory->dissipated_budget);
    for (auto& point : memory->points) point.state(archive);
}

}  // namespace weavefront::contact
