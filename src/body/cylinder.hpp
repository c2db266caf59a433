#pragma once
/// @file
/// A cylinder with rounded edges.

#include "meridian.hpp"
#include "weavefront/body/shape.hpp"

namespace weavefront::body {

/// Cylinder about z with rounded edges.
class Cylinder final : public Shape {
  public:
    /// Faces of a cylinder.
    enum Faces : Face { none, front, side, rear };

    /// @param diameter    m
    /// @param edge_radius m, at most half of the diameter and of the length
    /// @param length      m
    Cylinder(double diameter, double edge_radius, double length)
        : diameter_(diameter), edge_radius_(edge_radius), length_(length) {}

    [[nodiscard]] std::optional<Depth> depth(const Vec3& point, double offset, Face& face) const override;
    [[nodiscard]] Bounds bounds() const override;
    [[nodiscard]] double radius() const override { return diameter_ / 2; }
    [[nodiscard]] MassProperties mass_properties() const override;
    [[nodiscard]] double presented_area(const Vec3& direction) const override;
    [[nodiscard]] Outline outline() const override;

  private:
    [[nodiscard]] Meridian meridian() const;

    double diameter_, edge_radius_, length_;  ///< m
};

}  // namespace weavefront::body
