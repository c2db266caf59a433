#pragma once
/// @file
/// Contact between the projectile and the fabric, on the rank that owns the element.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/body/shape.hpp"
#include "weavefront/contact/facet_quadrature.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/rigid_pressure.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/swept_bounds.hpp"

namespace weavefront::contact {

/// Nose position and velocity of the projectile.
struct ProjectileState {
    Vec3 position{0, 0, 0};  ///< m
    Vec3 velocity{0, 0, 0};  ///< m/s
};

/// Contact at integration points pushes along the smoothed normals of the plies, see PushDirections. Contact
/// at the nodes pushes along the normals of the projectile.
class ProjectileContact {
  public:
    /// @param shape of the projectile
    /// @param x     initial positions, for the integration points, m
    ProjectileContact(std::shared_ptr<const body::Shape> shape, const scene::ContactLaw& law,
                      std::optional<double> spacing, const Surface& surface, std::span<const Vec3> x);

    /// Chooses the owned facets that may come under the projectile. They hold until a node or the projectile
    /// is more than half of `skin` outside of its swept bounds in x or y.
    /// @param swept bounds of the nodes
    /// @param way   footprint that the projectile's nose sweeps
    /// @param skin  m
    void update_candidates(const Surface& surface, const SweptBounds& swept, const Footprint& way,
                           double skin);

    /// Appends the forces at the present positions.
    /// @param normals of the plies, at these positions
    /// @param v       velocities over the last step, m/s
    /// @param dt      the last step, s
    /// @param sliding_share part of the overlap caused by sliding that may press, see Surroundings
    void evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                  std::span<const Vec3> v, const ProjectileState& projectile, double dt, double sliding_share,
                  ContactForces& forces);

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

    std::shared_ptr<const body::Shape> shape_;
    body::Bounds bounds_;  ///< of the shape, m
    double radius_;        ///< of the shape about its axis, m
    std::vector<OfPly> plies_;
    FacetQuadrature quadrature_;
    std::vector<std::int32_t> candidates_;      ///< owned facets
    FacetMemory<RigidMemory<Point>> memories_;  ///< of the owned facets
};

}  // namespace weavefront::contact
