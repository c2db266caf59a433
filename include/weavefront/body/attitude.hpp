#pragma once
/// @file
/// The attitude of a rigid body: the rotation from its axes to those of space.

#include <array>
#include <cmath>

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::body {

/// Unit quaternion with its rotation matrix. Only arithmetic and square roots, so every machine computes the
/// same bits.
class Attitude {
  public:
    /// The axes of the body are those of space.
    Attitude() = default;
    /// @param quaternion w, x, y, z, of any length but 0
    explicit Attitude(const std::array<double, 4>& quaternion);
    /// @param quaternion w, x, y, z, of length 1 to rounding: its bits are kept
    static Attitude of_unit(const std::array<double, 4>& quaternion);

    /// Whether the axes of the body are those of space.
    [[nodiscard]] bool is_identity() const { return q_ == std::array<double, 4>{1, 0, 0, 0}; }
    /// w, x, y, z
    [[nodiscard]] const std::array<double, 4>& quaternion() const { return q_; }
    /// Row of the rotation matrix: an axis of space in body axes.
    [[nodiscard]] const Vec3& row(std::size_t axis) const { return rows_[axis]; }
    /// From body axes to those of space.
    [[nodiscard]] Vec3 to_space(const Vec3& v) const {
        return {rows_[0].dot(v), rows_[1].dot(v), rows_[2].dot(v)};
    }
    /// From the axes of space to those of the body.
    [[nodiscard]] Vec3 to_body(const Vec3& v) const {
        return v.x() * rows_[0] + v.y() * rows_[1] + v.z() * rows_[2];
    }
    /// Turned by the Cayley transform of a rotation vector in body axes, whose angle is 2 atan(|v|/2).
    [[nodiscard]] Attitude turned(const Vec3& v) const;

  private:
    void find_rows();

    std::array<double, 4> q_{1, 0, 0, 0};
    std::array<Vec3, 3> rows_{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
};

}  // namespace weavefront::body
