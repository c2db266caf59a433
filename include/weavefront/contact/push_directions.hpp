#pragma once
/// @file
/// Directions in which a rigid body pushes fabric.

#include <array>
#include <optional>

#include "weavefront/contact/bilinear_quad.hpp"
#include "weavefront/contact/depth.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// Normals of a ply at the corners of a facet, of any length; none: the body pushes along its own normal, as
/// in node-to-surface contact.
using PlyNormals = std::optional<std::array<Vec3, 4>>;

/// Directions in which a body without friction pushes the points of a facet.
///
/// Edges and flat faces push along the normal of the ply, so that they do not pull on the yarns: the normals
/// of ply and body differ where an edge presses into the ply, and tensions would not be handed on from one
/// side of the edge to the other. A ply seen at more than 60 deg, as at the rim of a hole, leaves along the
/// normal of the body.
///
/// A round body whose curvature the elements resolve pushes along its own normal where the ply is wrapped
/// around it: the work of the force then is what the overlap stores. Where the ply is flat, it pushes along
/// the normal of the ply, along which sliding changes nothing. In between, the curvature of the ply over that
/// of the body decides.
class PushDirections {
  public:
    /// @param corners of the facet, m @param area of the facet, m2
    PushDirections(const PlyNormals& of_ply, const std::array<Vec3, 4>& corners, double area);

    /// At a point in the body. Not of unit length in between of the two normals.
    /// @param N shape functions, [corner]
    [[nodiscard]] Vec3 at(const Depth& depth, const ShapeFunctions& N, std::size_t i) const;

    /// The depth of a point that has just left the body, which then tells no normal.
    /// @param away direction from the body to the facet, of any length
    [[nodiscard]] Depth left_behind(const Vec3& away, const ShapeFunctions& N, std::size_t i) const;

  private:
    [[nodiscard]] Vec3 ply_normal(const ShapeFunctions& N, std::size_t i) const;

    PlyNormals of_ply_;
    double area_, curvature_ = 0;
};

}  // namespace weavefront::contact
