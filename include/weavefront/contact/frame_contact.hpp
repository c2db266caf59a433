#pragma once
/// @file
/// Contact between the fabric and the frame it rests on, on the rank that owns the element.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/contact/facet_quadrature.hpp"
#include "weavefront/contact/frame.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/rigid_pressure.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// One-sided contact: fabric may slide on the frame, with or without friction, and lift off, but cannot pass
/// through it. The frame pushes along the same directions as the projectile, see PushDirections.
class FrameContact {
  public:
    /// The last ply of `surface` rests on the frame at the start. @param x initial positions, m
    FrameContact(const scene::Frame& frame, const scene::ContactLaw& law, std::optional<double> spacing,
                 const Surface& surface, std::span<const Vec3> x);

    /// Appends the forces at the present positions.
    /// @param normals of the plies, at these positions
    /// @param v       velocities over the last step, m/s
    /// @param dt      the last step, s
    /// @param sliding_share part of the overlap caused by sliding that may press, see Surroundings
    void evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                  std::span<const Vec3> v, double dt, double sliding_share, ContactForces& forces);

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

        template <class Archive>
        void state(Archive& archive) {
            penetration.state(archive);
        }
    };
    std::vector<FrameShape> shapes_;  ///< by ply: inflated by its thickness
    std::vector<PenaltyLaw> laws_;    ///< by ply
    std::optional<CoulombLaw> friction_;
    FacetQuadrature quadrature_;
    FacetMemory<RigidMemory<Point>> memories_;  ///< of the owned facets
};

}  // namespace weavefront::contact
