#pragma once
/// @file
/// Pressure and friction of a rigid body on one facet.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/body/depth.hpp"
#include "weavefront/body/rigid_body.hpp"
#include "weavefront/contact/contact_forces.hpp"
#include "weavefront/contact/coulomb.hpp"
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
    Vec3 away;                             ///< from the body to the facet, of any length
    body::Motion motion;                   ///< of the body
    bool turns = false;                    ///< whether moments turn the body
    const CoulombLaw* friction = nullptr;  ///< none: contact without friction
    std::uint16_t projectile = 0;          ///< number of the body, where it is a projectile
};

/// State of a facet's contact with a rigid body. `Point` has a member `penetration`.
template <class Point>
struct RigidMemory {
    std::vector<Point> points;                  ///< empty away from the body
    std::vector<TangentialTraction> tractions;  ///< of the points, empty without friction
    double dissipated_budget = 0;               ///< J/m2, see PenaltyLaw
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
        memory->points = std::vector<Point>(), memory->tractions = std::vector<TangentialTraction>();
}

/// Sums the tangential forces of a rigid body over the points of a facet.
class RigidFriction {
  public:
    /// @param tractions of the facet's points
    /// @pre `pair.friction` is there
    RigidFriction(const RigidPair& pair, const std::array<Vec3, 4>& corners,
                  const std::array<Vec3, 4>& velocities, double dt,
                  std::vector<TangentialTraction>& tractions)
        : pair_(pair),
          turn_(turn_of(corners, velocities, dt)),
          dt_(dt),
          tractions_(tractions),
          sum_(pair.facet.nodes, pair.body, pair.projectile) {
        if (tractions_.empty()) tractions_.resize(pair.rule.size() * batch_width);
    }

    /// A point that may press in this step.
    /// @param batch, lane of the point
    /// @param place    m
    /// @param pressure vector on the fabric, Pa
    /// @param relative velocity of the body less that of the fabric, m/s
    void add(std::size_t batch, std::size_t lane, const Vec3& place, const Vec3& pressure,
             const Vec3& relative) {
        const double size = pressure.norm();
        const Vec3 normal = size > 0 ? Vec3(pressure / size) : Vec3(Vec3::Zero());
        const auto& points = pair_.rule[batch];
        const Vec3 force = pair_.area * points.share[lane] *
                           pair_.friction->advance(tractions_[batch * batch_width + lane], normal, size,
                                                   {dt_ * relative, turn_});
        sum_.add(force, points.N, lane);
        if (pair_.turns) moment_ -= (place - pair_.motion.centre).cross(force);
    }

    /// Appends the force and the moment of the facet.
    void finish(ContactForces& forces) const {
        if (moment_ != Vec3::Zero()) forces.friction_moments.push_back({moment_, pair_.projectile});
        if (sum_.total != Vec3::Zero()) forces.friction.push_back(sum_);
    }

  private:
    const RigidPair& pair_;
    Vec3 turn_;  ///< of the facet, rad
    double dt_;
    std::vector<TangentialTraction>& tractions_;
    PairForce sum_;
    Vec3 moment_{0, 0, 0};
};

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
    PairForce sum(pair.facet.nodes, pair.body, pair.projectile);
    SlidingEnergy sliding;
    Vec3 moment = Vec3::Zero();
    std::optional<PushDirections> directions;
    std::optional<RigidFriction> friction;
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
            if (!pair.friction) continue;
            if (!friction) friction.emplace(pair, corners, velocities, nodes.dt, memory.tractions);
            friction->add(b, i, place, response.pressure * direction, relative);
        }
    }
    if (friction) friction->finish(forces);
    if (moment != Vec3::Zero()) forces.moments.push_back({moment, pair.projectile});
    if (sum.total != Vec3::Zero()) forces.pairs.push_back(sum);
    if (sliding.is_any()) forces.sliding.push_back(sliding.times(pair.area));
}

/// State of a facet that remembers a rigid body: its dissipated budget (J/m2), its points, each by its own
/// `state`, and their tractions. A facet without budget and points has none.
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
    const auto tractions = archive.size("traction_x", memory->tractions.size());
    if constexpr (Archive::reads) memory->tractions.resize(tractions);
    for (auto& traction : memory->tractions) traction.state(archive);
}

}  // namespace weavefront::contact
