#pragma once
/// @file
/// Coulomb friction at one contact point.

#include <algorithm>
#include <array>
#include <optional>

#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// State of a contact point with friction that lasts from step to step.
struct TangentialTraction {
    Vec3 traction{0, 0, 0};  ///< on the slave, Pa
    bool slips = false;      ///< whether it slipped in the last step

    template <class Archive>
    void state(Archive& archive) {
        archive("traction_x", traction[0]);
        archive("traction_y", traction[1]);
        archive("traction_z", traction[2]);
        double number = slips ? 1 : 0;
        archive("slips", number);
        slips = number != 0;
    }
};

/// Motion of the two sides of a contact point over the last step.
struct TangentialMotion {
    Vec3 slip;  ///< displacement of the master relative to the slave, m; its tangential part counts
    Vec3 turn;  ///< rotation vector of the slave, rad: see turn_of
};

/// Rotation vector of a quad over a step, rad: its tilt, and the mean spin of its plane about its normal. It
/// is 2 tan(a/2) about the axis for a rigid rotation by the angle a.
/// @param corners    at the end of the step, m
/// @param velocities over the step, m/s
[[nodiscard]] inline Vec3 turn_of(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& velocities,
                                  double dt) {
    const Vec3 e1 = dt * (velocities[2] - velocities[0]), e2 = dt * (velocities[3] - velocities[1]);
    // The diagonals in the middle of the step.
    const Vec3 d1 = corners[2] - corners[0] - e1 / 2, d2 = corners[3] - corners[1] - e2 / 2;
    const Vec3 normal = d1.cross(d2), change = e1.cross(d2) + d1.cross(e2);
    const double square = normal.squaredNorm();
    if (!(square > 0)) return Vec3::Zero();
    return (normal.cross(change) + (e1.dot(d2) - e2.dot(d1)) / 2 * normal) / square;
}

/// Coulomb friction with a stick branch: an elastic tangential traction that the pressure caps.
///
/// A point sticks: its traction grows along k_t times the tangential displacement of the step. Above the
/// static coefficient times the pressure it slips: the traction keeps its direction and falls to the kinetic
/// coefficient times the pressure. The point sticks again when the trial traction is below this cap, as it is
/// when the slip reverses. Where the pressure falls, the cap falls with it, and the stored elastic energy
/// t^2/(2 k_t) is dissipated. Without pressure there is no traction.
///
/// The traction turns with the slave and then into the tangent plane of the present normal; its magnitude
/// stays. The mean of the tractions at both ends of a step does the step's work. Work less stored energy is
/// dissipated. It is negative only in a step whose slip reverses and by itself exceeds the cap, and then by
/// at most k_t slip^2/8.
class CoulombLaw {
  public:
    /// @param friction  coefficients, and k_t over the stiffness of the normal law
    /// @param stiffness of the normal law while loading, Pa/m
    CoulombLaw(const scene::Friction& friction, double stiffness)
        : static_(friction.static_coefficient),
          kinetic_(friction.kinetic_coefficient),
          stiffness_(friction.stiffness_ratio * stiffness) {}

    /// The law of a contact; none where it has no friction.
    [[nodiscard]] static std::optional<CoulombLaw> of(const scene::ContactLaw& law) {
        if (!law.friction) return std::nullopt;
        return CoulombLaw(*law.friction, law.stiffness);
    }

    /// Advances a point by a step. @return the traction on the slave, Pa
    /// @param normal   of unit length, of either sign
    /// @param pressure present, Pa
    const Vec3& advance(TangentialTraction& point, const Vec3& normal, double pressure,
                        const TangentialMotion& motion) const {
        if (!(pressure > 0)) {
            point = {};
            return point.traction;
        }
        const Vec3 slip = motion.slip - motion.slip.dot(normal) * normal;
        const Vec3 trial = turned(point.traction, normal, motion.turn) + stiffness_ * slip;
        const double size = trial.norm(), cap = (point.slips ? kinetic_ : static_) * pressure;
        point.slips = size > cap;
        point.traction = point.slips ? Vec3(kinetic_ * pressure / size * trial) : trial;
        return point.traction;
    }

    /// Energy that a point returns when it slides back, J/m2.
    [[nodiscard]] double elastic_energy(const TangentialTraction& point) const {
        return point.traction.squaredNorm() / (2 * stiffness_);
    }

  private:
    static Vec3 turned(const Vec3& traction, const Vec3& normal, const Vec3& turn) {
        const double before = traction.norm();
        if (before == 0) return Vec3::Zero();
        const Vec3 half = turn / 2;
        const Vec3 with_slave =
            traction + turn.cross(traction + half.cross(traction)) / (1 + half.squaredNorm());
        const Vec3 tangential = with_slave - with_slave.dot(normal) * normal;
        const double after = tangential.norm();
        return after > 0 ? Vec3(before / after * tangential) : Vec3(Vec3::Zero());
    }

    double static_, kinetic_;
    double stiffness_;  ///< k_t, Pa/m
};

}  // namespace weavefront::contact
