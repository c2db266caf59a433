#pragma once
/// @file
/// Directions in which a rigid body pushes fabric.

#include <array>
#include <optional>

#include "weavefront/body/depth.hpp"
#include "weavefront/contact/bilinear_quad.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// Normals of a ply at the corners of a facet, of any length. None: the body pushes along its own normal, as
/// in node-to-surface contact.
using PlyNormals = std::optional<std::array<Vec3, 4>>;

/// Directions in which the pressure of a rigid body pushes the points of a facet.
///
/// Edges and flat faces push along the normal of the ply. Where an edge presses into the ply, the normals of
/// ply and body differ. A force along the normal of the body would pull on the yarns, and their tension would
/// jump across the edge. A ply inclined by more than 60 deg, as at the edge of a hole, is pushed along the
/// normal of the body.
///
/// A round body whose curvature the elements resolve pushes along its own normal where the ply is wrapped
/// around it. There the work of the force is the energy that the overlap stores. Where the ply is flat, the
/// body pushes along the normal of the ply, along which sliding does no work. In between, the ratio of the
/// curvatures of ply and body weights the two normals.
class PushDirections {
  public:
    /// @param corners of the facet, m @param area of the facet, m2
    PushDirections(const PlyNormals& of_ply, const std::array<Vec3, 4>& corners, double area);

    /// Direction at a point in the body. Between the two normals its length is below 1.
    /// @param N shape functions, [corner]
    [[nodiscard]] Vec3 at(const body::Depth& depth, const ShapeFunctions& N, std::size_t i) const;

    /// Depth 0 of a point that has just left the body, where the body has no normal.
    /// @param away direction from the body to the facet, of any length
    [[nodiscard]] body::Depth left_behind(const Vec3& away, const ShapeFunctions& N, std::size_t i) const;

  private:
    [[nodiscard]] Vec3 ply_normal(const ShapeFunctions& N, std::size_t i) const;

    PlyNormals of_ply_;
    double area_, curvature_ = 0;
};

}  // namespace weavefront::contact
