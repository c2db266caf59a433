#pragma once
/// @file
/// A body of revolution.

#include "meridian.hpp"
#include "weavefront/body/shape.hpp"

namespace weavefront::body {

/// Body of revolution about z. Its faces are the segments of its meridian, numbered from 1 at the nose.
///
/// A point keeps its face while it projects on it. Beyond a convex edge, depth and normal go over to those of
/// the next face within the offset, so neither jumps. The inflated shape has rounded edges.
class RevolvedProfile final : public Shape {
  public:
    /// @param meridian from (0, 0) to the axis at the rear, connected, without crossings
    explicit RevolvedProfile(Meridian meridian);

    [[nodiscard]] std::optional<Depth> depth(const Vec3& point, double offset, Face& face) const override;
    [[nodiscard]] Bounds bounds() const override;
    [[nodiscard]] double radius() const override { return radius_; }
    [[nodiscard]] MassProperties mass_properties() const override { return mass_of_revolution(meridian_); }
    [[nodiscard]] double presented_area(const Vec3& direction) const override;
    [[nodiscard]] Outline outline() const override { return revolve(meridian_); }

  private:
    using Point = Eigen::Vector2d;  ///< (r, z), m

    /// A point seen from a segment.
    struct Seen {
        double height;        ///< outside of the segment's line or circle, m; < 0 inside the body
        Point normal;         ///< outward
        double radius;        ///< smaller radius of curvature of the surface, m; 0: flat
        bool before, beyond;  ///< whether the point projects beyond the start, the end
    };
    /// The directions of an arc from its centre.
    struct Sector {
        Point middle{0, 1};
        double cosine_of_half = 1;  ///< of half the angle of the arc
    };
    /// Depth in the half-plane.
    struct Found {
        double depth;
        Point normal;
        double radius;
    };
    /// Meeting of two segments, or of a segment and the axis.
    struct Joint {
        Point at;
        Point in, out;  ///< directions of the segments before and behind it, along the meridian
        double turn;    ///< sine of the angle between them; > 0: convex
    };

    static Sector sector_of(const Segment& segment);
    [[nodiscard]] Seen seen(std::size_t segment, const Point& point, double offset) const;
    /// Segment nearest to a point. @param height receives the distance to the body, m; < 0 inside
    [[nodiscard]] std::size_t nearest(const Point& point, double& height) const;
    /// Depth seen from a face and, beyond its ends, from those that follow. @param segment updated
    [[nodiscard]] Found follow(const Point& point, double offset, std::size_t& segment) const;
    /// Depth below the rounded edge at a joint.
    [[nodiscard]] Found at_edge(const Joint& joint, const Point& point, double offset) const;
    /// The deeper neighbour at a concave joint beside which a point lies in front of both; else `segment`.
    [[nodiscard]] std::size_t deeper_neighbour(std::size_t segment, double height, const Point& point,
                                               double offset) const;

    Meridian meridian_;
    std::vector<Sector> sectors_;   ///< of the segments
    std::vector<Joint> joints_;     ///< joint k is the start of segment k
    double radius_, front_, rear_;  ///< m
};

}  // namespace weavefront::body
