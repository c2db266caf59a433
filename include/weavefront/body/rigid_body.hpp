#pragma once
/// @file
/// The motion of a rigid body.

#include <array>
#include <span>
#include <string>

#include "weavefront/body/attitude.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::body {

/// Force and moment about the centre of mass, N, N m.
struct Wrench {
    Vec3 force{0, 0, 0}, moment{0, 0, 0};
};

/// Mass and its distribution, in body axes.
struct Inertia {
    double mass = 0;       ///< kg
    Vec3 centre{0, 0, 0};  ///< of mass, relative to the reference point, m
    std::array<Vec3, 3> tensor{Vec3(1, 0, 0), Vec3(0, 1, 0),
                               Vec3(0, 0, 1)};  ///< rows, about the centre of mass, kg m2
};

/// Velocities of the points of a rigid body.
struct Motion {
    Vec3 centre{0, 0, 0};            ///< of mass, m
    Vec3 velocity{0, 0, 0};          ///< of the centre of mass, m/s
    Vec3 angular_velocity{0, 0, 0};  ///< rad/s

    /// @param point in space, m
    [[nodiscard]] Vec3 at(const Vec3& point) const {
        return velocity + angular_velocity.cross(point - centre);
    }
};

/// A rigid body in the scheme of central differences (solver/central_difference.hpp): positions and attitude
/// at the ends of the steps, velocity and angular momentum in their middle.
///
///     L(n+1/2) = L(n-1/2) + (dt(n-1) + dt(n))/2 M(n)
///     P(n+1)   = P(n) + dt(n) (P(n) + P(n+1))/2 x W,   W = J^-1 (P(n) + P(n+1))/2
///     R(n+1)   = R(n) cay(dt(n) W)
///
/// L is the angular momentum in space, P = R^T L that in body axes and J the inertia tensor. Without a moment
/// the midpoint rule conserves L and the energy L.(R J^-1 R^T L)/2 to rounding (Simo and Wong, Int. J.
/// Numer. Methods Eng. 31 (1991) 19; Lewis and Simo, J. Nonlinear Sci. 4 (1994) 253).
class RigidBody {
  public:
    /// @param turns whether moments turn the body; one that does not keeps its attitude
    RigidBody(const Inertia& inertia, bool turns);

    /// Places the body. @param position of the reference point, m @param velocity of the centre of mass, m/s
    void place(const Vec3& position, const Attitude& attitude, const Vec3& velocity);
    /// @param angular_velocity in the axes of space, rad/s
    /// @pre the body turns, and it has been placed
    void spin(const Vec3& angular_velocity);

    [[nodiscard]] bool turns() const { return turns_; }
    [[nodiscard]] double mass() const { return inertia_.mass; }
    /// Of the reference point, m.
    [[nodiscard]] const Vec3& position() const { return position_; }
    [[nodiscard]] const Attitude& attitude() const { return attitude_; }
    /// Of the centre of mass, m/s.
    [[nodiscard]] const Vec3& velocity() const { return velocity_; }
    [[nodiscard]] const Vec3& angular_momentum() const { return angular_momentum_; }
    /// R J^-1 R^T L at the present attitude, rad/s; 0 for a body that does not turn.
    [[nodiscard]] const Vec3& angular_velocity() const { return angular_velocity_; }
    /// Of the centre of mass, m.
    [[nodiscard]] Vec3 centre() const { return position_ + arm_; }
    [[nodiscard]] Motion motion() const { return {centre(), velocity_, angular_velocity_}; }
    /// From space to body axes, relative to the reference point, m.
    [[nodiscard]] Vec3 to_body(const Vec3& point) const { return attitude_.to_body(point - position_); }
    /// From body axes, relative to the reference point, to space, m.
    [[nodiscard]] Vec3 to_space(const Vec3& point) const { return position_ + attitude_.to_space(point); }
    /// Angular velocity at the present attitude of an angular momentum in space, rad/s.
    [[nodiscard]] Vec3 angular_velocity_of(const Vec3& angular_momentum) const;
    /// Kinetic energy that closes the ledger: v(n-1/2).(v(n-1/2) + dt(n-1) a(n)) m/2 and the like of the
    /// rotation, J. @param wrench at the present time
    [[nodiscard]] double kinetic_energy(const Wrench& wrench, double last_dt) const;

    /// Takes velocity and angular momentum to the middle of the next step.
    /// @param step from the middle of the last step to that of the next one, s
    void accelerate(const Wrench& wrench, double step);
    /// Moves and turns the body over a step. @param dt s
    void move(double dt);

    template <class Archive>
    void state(Archive& archive, const std::string& name) {
        archive(name + ".x", position_[0]);
        archive(name + ".y", position_[1]);
        archive(name + ".z", position_[2]);
        archive(name + ".vx", velocity_[0]);
        archive(name + ".vy", velocity_[1]);
        archive(name + ".vz", velocity_[2]);
        if (!turns_) return;
        auto quaternion = attitude_.quaternion();
        archive(name + ".attitude", std::span<double>(quaternion));
        archive(name + ".angular_momentum", std::span<double>(angular_momentum_.data(), 3));
        if (Archive::reads) restore(quaternion);
    }

  private:
    void restore(const std::array<double, 4>& quaternion);
    void turn(double dt);
    [[nodiscard]] Vec3 inverse_times(const Vec3& v) const {
        return {inverse_[0].dot(v), inverse_[1].dot(v), inverse_[2].dot(v)};
    }

    Inertia inertia_;
    std::array<Vec3, 3> inverse_;  // rows of J^-1
    bool turns_;
    Vec3 position_{0, 0, 0}, velocity_{0, 0, 0};
    Attitude attitude_;
    Vec3 angular_momentum_{0, 0, 0};
    Vec3 arm_{0, 0, 0};               // from the reference point to the centre of mass, in space
    Vec3 angular_velocity_{0, 0, 0};  // of the angular momentum at the present attitude
};

}  // namespace weavefront::body
