#pragma once
/// @file
/// A closed surface of triangles.

#include <unsupported/Eigen/BVH>
#include <vector>

#include "meridian.hpp"
#include "weavefront/body/shape.hpp"

namespace weavefront::body {

/// Points and triangles, whose corners run counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3> points;  ///< m
    std::vector<std::array<std::int32_t, 3>> corners;
};

/// Prism along y. @param parts convex quads (x, z) side by side, each counter-clockwise seen from -y, m
/// @param width along y, m
TriangleMesh extrude(const std::vector<std::vector<MeridianPoint>>& parts, double width);

/// Closed surface of triangles. Its faces are the triangles, numbered from 1.
///
/// A point keeps its triangle while it projects on it. Beyond a convex edge, depth and normal go over to
/// those of the next triangle within the offset. The sign of a distance is that of the angle-weighted
/// pseudo-normals of Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243.
class TriangulatedSurface final : public Shape {
  public:
    /// @param mesh closed and consistently oriented
    explicit TriangulatedSurface(TriangleMesh mesh);

    [[nodiscard]] std::optional<Depth> depth(const Vec3& point, double offset, Face& face) const override;
    [[nodiscard]] Bounds bounds() const override { return bounds_; }
    [[nodiscard]] double radius() const override { return radius_; }
    [[nodiscard]] MassProperties mass_properties() const override;
    [[nodiscard]] double presented_area(const Vec3& direction) const override;
    [[nodiscard]] Outline outline() const override;

  private:
    /// The point of the surface nearest to another one.
    struct Closest {
        double height;  ///< distance to the surface, m; < 0 inside
        Vec3 normal;    ///< outward, along that distance
        std::int32_t triangle;
    };
    struct Triangle {
        std::array<Vec3, 3> corners;
        Vec3 normal;
        std::array<Vec3, 3> outward;             ///< in its plane, away from edge e from corner e to e + 1
        std::array<std::int32_t, 3> neighbours;  ///< across the edges
        std::array<double, 3> turn;              ///< sine of the angle to them; > 0: convex
        std::array<Vec3, 3> corner_normals;      ///< pseudo-normals
    };

    void join(const TriangleMesh& mesh);
    /// @param start a face with which the search begins; 0: none
    [[nodiscard]] Closest closest(const Vec3& point, Face start) const;
    /// Depth seen from a triangle and, beyond its edges, from those that follow. @param triangle updated
    [[nodiscard]] Depth follow(const Vec3& point, double offset, const Closest& closest,
                               std::int32_t& triangle) const;
    [[nodiscard]] const Triangle& at(std::int32_t triangle) const {
        return triangles_[static_cast<std::size_t>(triangle)];
    }

    std::vector<Triangle> triangles_;
    Eigen::KdBVH<double, 3, std::int32_t> tree_;
    Bounds bounds_;
    double radius_ = 0;  ///< m
};

}  // namespace weavefront::body
