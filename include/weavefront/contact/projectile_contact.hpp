#pragma once
/// @file
/// Contact between the projectile and the fabric, on the rank that owns the element.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/facet_quadrature.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/projectile.hpp"
#include "weavefront/contact/rigid_pressure.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/swept_bounds.hpp"

namespace weavefront::contact {

/// Nose position and velocity of the projectile.
struct ProjectileState {
    Vec3 position{0, 0, 0};  ///< m
    Vec3 velocity{0, 0, 0};  ///< m/s
};

/// Integrated contact pushes along the smoothed normals of the plies, as contact between them does; contact
/// at the nodes along those of the projectile.
class ProjectileContact {
  public:
    /// @param x initial positions, for the integration points, m
    ProjectileContact(const scene::Projectile& projectile, const scene::ContactLaw& law,
                      std::optional<double> spacing, const Surface& surface, std::span<const Vec3> x);

    /// Chooses the owned facets that may come under the projectile while no node, nor the projectile, is more
    /// than half of `skin` away from where it is expected in x or y.
    /// @param way footprint of the way of the projectile's nose
    void update_candidates(const Surface& surface, const SweptBounds& swept, const Footprint& way,
                           double skin);

    /// Appends the forces at the present positions.
    /// @param normals of the plies, at these positions
    /// @param v       velocities over the last step, m/s
    /// @param dt      the last step, s
    /// @param sliding_share part of the overlap brought about by sliding that may press, see Surroundings
    void evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                  std::span<const Vec3> v, const ProjectileState& projectile, double dt, double sliding_share,
                  ContactForces& forces);

    /// Owned facets that may come under the projectile before the next search.
    [[nodiscard]] std::span<const std::int32_t> candidates() const { return candidates_; }

    /// Whether any point of an owned facet remembers a penetration, or may soon.
    [[nodiscard]] bool touches(std::int32_t facet) const {
        const auto* memory = memories_.find(facet);
        return memory && !memory->points.empty();
    }
    /// Memory of the points of an owned facet, to be taken up on another rank.
    void save(std::int32_t facet, std::vector<double>& record) const;
    /// @param record of `save`, with anything after it. @return what comes after it
    std::span<const double> restore(std::int32_t facet, std::span<const double> record);

  private:
    struct Point {
        Penetration penetration;
        Side side = Side::none;
    };

    std::vector<ProjectileShape> shapes_;  ///< by ply: inflated by its thickness
    std::vector<PenaltyLaw> laws_;         ///< by ply
    FacetQuadrature quadrature_;
    std::vector<std::int32_t> candidates_;      ///< owned facets
    FacetMemory<RigidMemory<Point>> memories_;  ///< of the owned facets
};

}  // namespace weavefront::contact
