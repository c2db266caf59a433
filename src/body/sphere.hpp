#pragma once
/// @file
/// A sphere.

#include "weavefront/body/shape.hpp"

namespace weavefront::body {

/// Sphere that touches the origin from -z. It has one face.
class Sphere final : public Shape {
  public:
    /// @param diameter m
    explicit Sphere(double diameter) : diameter_(diameter) {}

    [[nodiscard]] std::optional<Depth> depth(const Vec3& point, double offset, Face& face) const override;
    [[nodiscard]] Bounds bounds() const override;
    [[nodiscard]] double radius() const override { return diameter_ / 2; }
    [[nodiscard]] MassProperties mass_properties() const override;
    [[nodiscard]] double presented_area(const Vec3& direction) const override;
    [[nodiscard]] Outline outline() const override;

  private:
    double diameter_;  ///< m
};

}  // namespace weavefront::body
