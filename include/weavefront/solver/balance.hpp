#pragma once
/// @file
/// The energy ledger and the motion at one time.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "weavefront/contact/deepest.hpp"
#include "weavefront/mesh/vec3.hpp"

namespace weavefront::solver {

/// Rotation of a projectile that turns.
struct Rotation {
    std::array<double, 4> attitude{1, 0, 0, 0};  ///< quaternion w, x, y, z from its axes to those of space
    Vec3 angular_velocity{0, 0, 0},
        moment{0, 0, 0};  ///< in the axes of space, about its centre of mass, rad/s, N m
};

/// A projectile at the time of a balance.
struct ProjectileNow {
    Vec3 position{0, 0, 0};       ///< of its nose, m
    Vec3 velocity{0, 0, 0};       ///< m/s
    Vec3 contact_force{0, 0, 0};  ///< on the projectile, N
    std::optional<Rotation> rotation = {};
};

/// Everything refers to the whole target, also when a symmetric part is modelled. Energies in J.
///
/// Work is counted as the trapezoid of the forces over each step. With the kinetic energy taken as m
/// v(n-1/2).(v(n-1/2) + a(n) dt)/2 the sum of all columns then stays constant to rounding as far as each
/// column counts what the nodal forces do; the ledger counts what the yarns, the hourglass potential and the
/// contact points do, so the defect tests the kernel, not the bookkeeping.
struct Balance {
    double time = 0;
    std::vector<ProjectileNow> projectiles;
    double kinetic_fabric = 0, kinetic_projectile = 0;  ///< of the fabric, of all projectiles
    double internal = 0;   ///< work done on the yarns and on their packing, stored or not
    double hourglass = 0;  ///< potential of the hourglass modes and of warping
    double contact = 0;    ///< stored and damped in contact, without its friction
    double friction = 0;   ///< of the yarns
    double damping = 0;
    double external = 0;      ///< done by supports: none of them moves
    double eroded = 0;        ///< hourglass energy let go with broken yarns and eroded elements
    double energy_error = 0;  ///< closure error over the initial energy
    double transferred_energy =
        0;  ///< most that was elsewhere than in the projectiles up to now, J; at least what the sums resolve
    double closure_error =
        0;  ///< closure error over the transferred energy: what a heavy projectile keeps cannot hide it
    std::int64_t broken_yarns = 0, eroded_elements = 0;
    double max_displacement = 0;      ///< of a node of joined fabric along z, m: see JoinedFabric
    double back_face_deflection = 0;  ///< of joined fabric of the last ply along z, the largest, m
    double time_step = 0;             ///< s
    contact::Deepest deepest;         ///< penetration up to now
    std::int64_t debris_elements = 0, folded_elements = 0;
    double debris_mass = 0;          ///< kg
    double debris_displacement = 0;  ///< of a node of debris along z, the largest, m
    std::optional<double> contact_friction =
        {};  ///< taken by the tangential forces of contact, stored or not; none without such friction

    /// What must stay constant, J.
    [[nodiscard]] double total() const {
        return kinetic_fabric + kinetic_projectile + internal + hourglass + contact + friction + damping +
               eroded - external + contact_friction.value_or(0);
    }
};

/// Refuses a balance that does not close, and energy from nowhere: what yarns, friction, contact or friction
/// of contact have given beyond what they had taken.
/// @param limit of the closure error and of that energy, over the transferred energy
/// @throws GuardStop
void require_balance(const Balance& balance, double limit, std::int64_t step);

}  // namespace weavefront::solver
