#pragma once
/// @file
/// What the kernels need of a fabric and of a time step, derived once.

#include <cmath>
#include <numbers>

#include "weavefront/fabric/features.hpp"
#include "weavefront/simd/math.hpp"

namespace weavefront::fabric {

using namespace simd;

/// A fabric's numbers, SI.
struct Constants {
    // cell
    double span = 0;                 ///< s
    double area = 0;                 ///< S
    double width = 0;                ///< w
    double thickness = 0;            ///< t
    double effective_thickness = 0;  ///< t_e
    double length = 0;               ///< L, IT04 (34)
    double inverse_length = 0;       ///< 1/L
    // yarn
    double static_modulus = 0;          ///< E1
    double hooke_modulus = 0;           ///< Ka
    double instant_modulus = 0;         ///< Ka, or E1 of a yarn without viscosity
    double viscosity = 0;               ///< mu_b
    double relaxation_time = 0;         ///< tau = mu_b/(Ka + Kb), s
    double inverse_primary_stress = 0;  ///< 1/(Ka eps_a_max), IT04 (19)
    double inverse_secondary_stress =
        0;  ///< 1/(Ka eps_b_max), eps_b_max = (Ka - E1)/Ka eps_max, IT04 (20),(22)
    // packing
    double lateral_modulus = 0;  ///< E2
    double shear_modulus = 0;    ///< G12
    double locking_angle = 0;    ///< theta_lock, from 45 deg
    double transition = 0;       ///< Dtheta, at least `smallest_transition`
    // friction
    double friction = 0;           ///< mu
    double packed_cos_2theta = 1;  ///< largest |cos 2 theta| at which IT04 (43),(45) are evaluated
};

/// A contact factor that jumps would make packing forces jump: a transition of zero is taken as this angle,
/// rad.
inline constexpr double smallest_transition = 1e-6;

/// The friction moment grows without bound as theta -> 0 or 90 deg. It is evaluated at the locking angle
/// beyond locking; a fabric that locks later than this many degrees short of flat is taken to lock there.
inline constexpr double smallest_packed_angle = 1.0;

/// Derives the numbers of `fabric`.
/// @param fabric validated: positive span, area and densities, Ka > E1
[[nodiscard]] inline Constants constants_of(const scene::Fabric& fabric) {
    const double s = fabric.yarn.span;
    const double t = fabric.thickness;
    Constants c{.span = s,
                .area = fabric.yarn.area,
                .width = fabric.yarn.width,
                .thickness = t,
                .effective_thickness = fabric.effective_thickness(),
                .length = sqrt(s / 2 * (s / 2) + t / 4 * (t / 4)),  // IT04 (34)
                .static_modulus = fabric.elastic.static_modulus,
                .hooke_modulus = fabric.elastic.hooke_modulus,
                .instant_modulus = fabric.elastic.viscosity > 0 ? fabric.elastic.hooke_modulus
                                                                : fabric.elastic.static_modulus,
                .viscosity = fabric.elastic.viscosity,
                .friction = fabric.friction};
    c.inverse_length = 1 / c.length;
    const double E1 = c.static_modulus;
    const double Ka = c.hooke_modulus;
    c.relaxation_time = c.viscosity * (Ka - E1) / (Ka * Ka);  // mu_b/(Ka + Kb) with Kb of IT04 (21)
    if (fabric.failure) {
        c.inverse_primary_stress = 1 / (Ka * fabric.failure->hooke_strain);
        c.inverse_secondary_stress = 1 / ((Ka - E1) * fabric.failure->static_strain);
    }
    // theta_min of IT04 (1) unless the locking angle is given: cos 2 theta_min = sin 2 theta_lock
    const double sin_2theta_min = min(1.0, c.width / s);
    c.packed_cos_2theta = sqrt(1 - sin_2theta_min * sin_2theta_min);
    if (fabric.lateral) {
        c.lateral_modulus = fabric.lateral->modulus;
        c.shear_modulus = fabric.lateral->shear_modulus;
        c.locking_angle = fabric.lateral->locking_angle;
        c.transition = max(fabric.lateral->transition, smallest_transition);
        c.packed_cos_2theta = sine(2 * c.locking_angle);
    }
    c.packed_cos_2theta =
        min(c.packed_cos_2theta, sine((90 - 2 * smallest_packed_angle) * std::numbers::pi / 180));
    return c;
}

/// How strongly the stretches of fill and warp are coupled through a free crossover at rest: the mixed second
/// derivative of the yarns' energy per reference area, k cos^2 beta/4 with k = S Ka/L, N/m. None between
/// straight yarns.
[[nodiscard]] inline double coupling_at_rest(const Constants& c) {
    const double cosine = c.span / 2 * c.inverse_length;
    return c.thickness > 0 ? c.instant_modulus * c.area * c.inverse_length * cosine * cosine / 4 : 0.0;
}

/// What depends on the time step only: sigma^{n+1} = sigma^n + relaxed (E1 eps^n - sigma^n) + modulus
/// (eps^{n+1} - eps^n).
struct Step {
    double relaxed = 0;  ///< part of the way to the static stress, 1
    double modulus = 0;  ///< of the strain increment, Pa
};

/// Coefficients of the yarn's stress update. With a = dt/tau = 2/beta:
/// paper IT04 (18), relaxed = 2a/(2 + a), modulus = (2 Ka + a E1)/(2 + a);
/// consistent, exact for a strain linear over the step: relaxed = 1 - e^-a, modulus = E1 + (Ka - E1)(1 -
/// e^-a)/a.
/// @param dt time step, s, >= 0; valid for dt/tau from 0 to 1e12
[[nodiscard]] inline Step step_of(const Constants& c, const Features& features, double dt) {
    const double E1 = c.static_modulus;
    if (!features.viscous) return {.relaxed = 1, .modulus = E1};
    const double a = dt / c.relaxation_time;
    if (features.paper())
        return {.relaxed = 2 * a / (2 + a), .modulus = (2 * c.hooke_modulus + a * E1) / (2 + a)};
    const double relaxed = one_minus_exp(a);
    return {.relaxed = relaxed,
            .modulus = a > 0 ? E1 + (c.hooke_modulus - E1) * (relaxed / a) : c.hooke_modulus};
}

}  // namespace weavefront::fabric
