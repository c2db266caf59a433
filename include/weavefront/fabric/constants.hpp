#pragma once
/// @file
/// What the kernels need of a fabric and of a time step, derived once.

#include <cmath>
#include <numbers>

#include "weavefront/fabric/features.hpp"
#include "weavefront/simd/math.hpp"

namespace weavefront::fabric {

using namespace simd;

/// Numbers of the fill or of the warp, SI.
struct YarnConstants {
    // cell
    double span = 0;            ///< s, between crossovers along the yarn; the yarns of the other system are
                                ///< so far apart
    double area = 0;            ///< S
    double width = 0;           ///< w
    double height = 0;          ///< of the crossover at rest; t/4 where fill and warp are equal
    double length = 0;          ///< L, IT04 (34)
    double inverse_length = 0;  ///< 1/L
    double share = 0;           ///< of the fibre, 1
    // yarn
    double static_modulus = 0;          ///< E1
    double hooke_modulus = 0;           ///< Ka
    double instant_modulus = 0;         ///< Ka, or E1 of a yarn without viscosity
    double viscosity = 0;               ///< mu_b
    double relaxation_time = 0;         ///< tau = mu_b/(Ka + Kb), s
    double inverse_primary_stress = 0;  ///< 1/(Ka eps_a_max), IT04 (19)
    double inverse_secondary_stress =
        0;  ///< 1/(Ka eps_b_max), eps_b_max = (Ka - E1)/Ka eps_max, IT04 (20),(22)
};

/// A fabric's numbers, SI.
struct Constants {
    YarnConstants fill;
    YarnConstants warp;              ///< read where `Features::unequal`; as the fill otherwise
    double thickness = 0;            ///< t
    double effective_thickness = 0;  ///< t_e
    // packing
    double lateral_modulus = 0;  ///< E2
    double shear_modulus = 0;    ///< G12
    double locking_angle = 0;    ///< theta_lock, from 45 deg
    double transition = 0;       ///< Dtheta, at least `smallest_transition`
    // friction
    double friction = 0;           ///< mu
    double packed_cos_2theta = 1;  ///< largest |cos 2 theta| at which IT04 (43),(45) are evaluated
};

/// The warp's numbers. Where fill and warp are equal they are read from the fill, so that a kernel loads one
/// set only.
template <Features F>
[[nodiscard]] WEAVEFRONT_INLINE const YarnConstants& warp_of(const Constants& c) {
    if constexpr (F.unequal) return c.warp;
    return c.fill;
}

/// Reference area of the cell, in which one yarn of either system crosses: s_f s_w, m2.
template <Features F>
[[nodiscard]] WEAVEFRONT_INLINE double cell_area(const Constants& c) {
    return c.fill.span * warp_of<F>(c).span;
}

/// A contact factor that jumps would make packing forces jump: a transition of zero is taken as this angle,
/// rad.
inline constexpr double smallest_transition = 1e-6;

/// The friction moment grows without bound as theta -> 0 or 90 deg. It is evaluated at the locking angle
/// beyond locking; a fabric that locks later than this many degrees short of flat is taken to lock there.
inline constexpr double smallest_packed_angle = 1.0;

/// Without packing, an angle that no trellis reaches, rad.
inline constexpr double unreached_angle = 4;

/// Derives the numbers of fill or warp. @param height of the crossover at rest, m
[[nodiscard]] inline YarnConstants yarn_constants_of(const scene::YarnSystem& system, double height) {
    const double s = system.yarn.span;
    const double E1 = system.elastic.static_modulus, Ka = system.elastic.hooke_modulus;
    YarnConstants c{.span = s,
                    .area = system.yarn.area,
                    .width = system.yarn.width,
                    .height = height,
                    .length = sqrt(s / 2 * (s / 2) + height * height),  // IT04 (34)
                    .static_modulus = E1,
                    .hooke_modulus = Ka,
                    .instant_modulus = system.elastic.viscosity > 0 ? Ka : E1,
                    .viscosity = system.elastic.viscosity};
    c.inverse_length = 1 / c.length;
    c.relaxation_time = c.viscosity * (Ka - E1) / (Ka * Ka);  // mu_b/(Ka + Kb) with Kb of IT04 (21)
    if (system.strength) {
        c.inverse_primary_stress = 1 / (Ka * system.strength->hooke_strain);
        c.inverse_secondary_stress = 1 / ((Ka - E1) * system.strength->static_strain);
    }
    return c;
}

/// Derives the numbers of `fabric`.
/// @param fabric validated: positive spans, areas and densities, Ka > E1
[[nodiscard]] inline Constants constants_of(const scene::Fabric& fabric) {
    const auto fill = fabric.fill_system(), warp = fabric.warp_system();
    Constants c{.fill = yarn_constants_of(fill, fill.crimp_height),
                // the difference, as the kernels take it: nothing is strained at rest
                .warp = yarn_constants_of(warp, fabric.thickness / 2 - fill.crimp_height),
                .thickness = fabric.thickness,
                .effective_thickness = fabric.effective_thickness(),
                .locking_angle = unreached_angle,
                .transition = smallest_transition,
                .friction = fabric.friction};
    const double of_fill = c.fill.area * c.fill.length, of_warp = c.warp.area * c.warp.length;
    c.fill.share = of_fill / (of_fill + of_warp);
    c.warp.share = of_warp / (of_fill + of_warp);
    // theta_min of IT04 (1) unless the locking angle is given: cos 2 theta_min = sin 2 theta_lock. The yarns
    // that touch first lock the trellis.
    const double sin_2theta_min = min(1.0, max(c.fill.width / c.warp.span, c.warp.width / c.fill.span));
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
/// straight yarns. @param c of a fabric whose fill and warp are equal
[[nodiscard]] inline double coupling_at_rest(const Constants& c) {
    const auto& yarn = c.fill;
    const double cosine = yarn.span / 2 * yarn.inverse_length;
    return c.thickness > 0 ? yarn.instant_modulus * yarn.area * yarn.inverse_length * cosine * cosine / 4
                           : 0.0;
}

/// What depends on the time step only: sigma^{n+1} = sigma^n + relaxed (E1 eps^n - sigma^n) + modulus
/// (eps^{n+1} - eps^n).
struct YarnStep {
    double relaxed = 0;  ///< part of the way to the static stress, 1
    double modulus = 0;  ///< of the strain increment, Pa
};

/// Coefficients of fill and warp.
struct Step {
    YarnStep fill;
    YarnStep warp;  ///< read where `Features::unequal`
};

/// The warp's coefficients, as `warp_of`.
template <Features F>
[[nodiscard]] WEAVEFRONT_INLINE const YarnStep& warp_of(const Step& step) {
    if constexpr (F.unequal) return step.warp;
    return step.fill;
}

/// Coefficients of the yarn's stress update. With a = dt/tau = 2/beta:
/// paper IT04 (18), relaxed = 2a/(2 + a), modulus = (2 Ka + a E1)/(2 + a);
/// consistent, exact for a strain linear over the step: relaxed = 1 - e^-a, modulus = E1 + (Ka - E1)(1 -
/// e^-a)/a.
/// @param dt time step, s, >= 0; valid for dt/tau from 0 to 1e12
[[nodiscard]] inline YarnStep yarn_step_of(const YarnConstants& c, const Features& features, double dt) {
    const double E1 = c.static_modulus;
    if (!features.viscous || c.viscosity == 0) return {.relaxed = 1, .modulus = E1};
    const double a = dt / c.relaxation_time;
    if (features.paper())
        return {.relaxed = 2 * a / (2 + a), .modulus = (2 * c.hooke_modulus + a * E1) / (2 + a)};
    const double relaxed = one_minus_exp(a);
    return {.relaxed = relaxed,
            .modulus = a > 0 ? E1 + (c.hooke_modulus - E1) * (relaxed / a) : c.hooke_modulus};
}

/// Coefficients of both yarns, as yarn_step_of.
[[nodiscard]] inline Step step_of(const Constants& c, const Features& features, double dt) {
    return {yarn_step_of(c.fill, features, dt), yarn_step_of(c.warp, features, dt)};
}

}  // namespace weavefront::fabric
