#pragma once
/// @file
/// Contact between a projectile and the fabric, on the rank that owns the element.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/body/rigid_body.hpp"
#include "weavefront/body/shape.hpp"
#include "weavefront/contact/facet_quadrature.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/rigid_pressure.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/swept_bounds.hpp"

namespace weavefront::contact {

/// Contact at integration points pushes along the smoothed normals of the plies, see PushDirections. Contact
/// at the nodes pushes along the normals of the projectile.
class ProjectileContact {
  public:
    /// @param shape      of the projectile
    /// @param projectile at the start
    /// @param x          initial positions, for the integration points, m
    /// @param number     of the projectile
    ProjectileContact(std::shared_ptr<const body::Shape> shape, const body::RigidBody& projectile,
                      const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface,
                      std::span<const Vec3> x, std::uint16_t number = 0);

    /// Chooses the owned facets that may come under the projectile. They hold until a node or the projectile
    /// is more than half of `skin` outside of its swept bounds in x or y.
    /// @param swept bounds of the nodes
    /// @param way   footprint that the projectile's search point sweeps
    /// @param skin  m
    void update_candidates(const Surface& surface, const SweptBounds& swept, const Footprint& way,
                           double skin);

    /// Appends the forces at the present positions.
    /// @param normals of the plies, at these positions
    /// @param v       velocities over the last step, m/s
    /// @param dt      the last step, s
    /// @param sliding_share part of the overlap caused by sliding that may press, see Surroundings
    void evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                  std::span<const Vec3> v, const body::RigidBody& projectile, double dt, double sliding_share,
                  ContactForces& forces);

    /// The point about which facets are searched within a radius: the nose of an upright projectile, else the
    /// middle of its bounds. @return in space, m
    [[nodiscard]] Vec3 search_point(const body::RigidBody& projectile) const {
        return is_upright_ ? projectile.position() : middle(projectile);
    }
    /// Middle of the projectile's bounds in space, m.
    [[nodiscard]] Vec3 middle(const body::RigidBody& projectile) const {
        return projectile.to_space((bounds_.low + bounds_.high) / 2);
    }
    /// Half of the projectile's extents along the axes of space, m.
    [[nodiscard]] Vec3 half_extents(const body::RigidBody& projectile) const;

    /// Owned facets that may come under the projectile before the next search.
    [[nodiscard]] std::span<const std::int32_t> candidates() const { return candidates_; }

    /// Whether an owned facet is in contact, or near enough for its points to have a face.
    [[nodiscard]] bool touches(std::int32_t facet) const {
        const auto* memory = memories_.find(facet);
        return memory && !memory->points.empty();
    }
    /// The largest penetration of an owned facet's points, m.
    [[nodiscard]] double penetration(std::int32_t facet) const {
        return largest_penetration(memories_, facet);
    }
    /// State of an owned facet.
    template <class Archive>
    void state(Archive& archive, std::int32_t facet) {
        facet_state(archive, memories_, facet);
    }

  private:
    struct Point {
        Penetration penetration;
        body::Face face = 0;

        template <class Archive>
        void state(Archive& archive) {
            penetration.state(archive);
            auto number = static_cast<double>(face);
            archive("face", number);
            face = static_cast<body::Face>(number);
        }
    };

    /// What the projectile is to a ply.
    struct OfPly {
        double offset;  ///< distance from the projectile at which the mid-surface touches it, m
        PenaltyLaw law;
    };

    std::uint16_t number_;
    std::shared_ptr<const body::Shape> shape_;
    body::Bounds bounds_;   ///< of the shape, m
    bool is_upright_;       ///< its axes are those of space, always
    double search_radius_;  ///< about the search point, m
    std::vector<OfPly> plies_;
    std::optional<CoulombLaw> friction_;
    FacetQuadrature quadrature_;
    std::vector<std::int32_t> candidates_;      ///< owned facets
    FacetMemory<RigidMemory<Point>> memories_;  ///< of the owned facets
};

}  // namespace weavefront::contact
