#pragma once
/// @file
/// Upper bounds of the cell's tangent, from which an element's critical time step follows.

#include <array>

#include "weavefront/fabric/friction.hpp"
#include "weavefront/fabric/lateral.hpp"

namespace weavefront::fabric {

/// Bounds in N/m such that for any change dg_f, dg_w of the yarn vectors (g = lambda d, three components) and
/// the change dpsi = d(2 theta) that goes with it, the second variation of the energy per reference area is
/// at most (yarn_f + lateral)|dg_f|^2 + (yarn_w + lateral)|dg_w|^2 + angle dpsi^2, where dpsi^2 <= 2
/// (|dg_f|^2/lambda_f^2 + |dg_w|^2/lambda_w^2).
template <class Real>
struct Stiffness {
    Real yarn_f, yarn_w;  ///< along and across the yarns
    Real lateral;         ///< packing, on either yarn
    Real angle;           ///< on the angle between the yarns
    /// Out of the plane: at most normal[0] dg_f^2 + 2 normal[1] dg_f dg_w + normal[2] dg_w^2.
    std::array<Real, 3> normal;
};

/// Instantaneous tangent of a state, bounded from above (see README.md, "Stiffness"):
/// - yarn: Ka S/s (s/2)/L, since dN/dlambda at a held crossover is (S/s)(Ka cos^2 beta (s/2)/L + sigma sin^2
/// beta cos beta/lambda), plus
///   the geometric |n|/lambda^2. Letting the crossover go can only soften yarns in tension: the relaxed
///   Hessian is W_ll - W_ld W_ld/W_dd with W_dd > 0. The second derivative of psi by the components of g adds
///   |m|/(2 lambda^2).
/// - packing: e_f = ln lambda_w + ln sin psi couples stretch and angle; (x + y)^2 <= 2 x^2 + 2 y^2 separates
/// them. Unpacking lets p go at a
///   rate dalpha/dpsi = 1/(2 Dtheta), as a spring of p/(2 alpha Dtheta) would.
/// - angle: packing with its geometric |p|/sin^2 psi, friction while it sticks, and the geometric |m|/2 (|cot
/// psi| + 1/sin psi) of yarns
///   that tilt out of plane.
/// - out of the plane: the tension n/lambda^2 with its sign and that same moment, cot psi (z_f^2 + z_w^2) - 2
/// z_f z_w/sin psi with
///   z = dg/lambda; in the paper's formulation |n|/lambda^2 and the mixed term by at most (z_f^2 + z_w^2)/sin
///   psi. The paper's stresses derive from no energy; there the same terms are an estimate, with the factor
/// lambda sin 2 theta by which its yarn force exceeds the conjugate one, and the shear gamma_12 = dpsi + cot
/// psi (dln lambda_f - dln lambda_w) of both yarns.
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE Stiffness<Real> stiffness_bound(const Constants& c,
                                                                const State<Real>& state) {
    const YarnConstants &fill = c.fill, &warp = warp_of<F>(c);
    const double yarn_f =
                     fill.instant_modulus * fill.area / warp.span * (0.5 * fill.span * fill.inverse_length),
                 yarn_w =
                     warp.instant_modulus * warp.area / fill.span * (0.5 * warp.span * warp.inverse_length);
    const Real inverse_f = 1.0 / state.lambda_f, inverse_w = 1.0 / state.lambda_w;
    Stiffness<Real> k{.yarn_f = yarn_f, .yarn_w = yarn_w, .lateral = 0.0, .angle = 0.0, .normal = {}};
    if constexpr (F.failure) {
        k.yarn_f *= state.intact_f;
        k.yarn_w *= state.intact_w;
    }
    Real turn = 0.0, Q = 0.0, cot_psi = 0.0, inverse_sin = 1.0;  // |m|, m/2 with its sign
    if constexpr (F.follows_angle()) {
        const Trellis<Real> trellis = trellis_of(state.cos_2theta);
        const Real inverse_sine = 1.0 / trellis.sin_2theta;
        const Real cot = abs(trellis.cos_2theta) * inverse_sine;
        if constexpr (F.paper()) {
            k.yarn_f *= max(Real(1.0), Real(state.lambda_w * trellis.sin_2theta));
            k.yarn_w *= max(Real(1.0), Real(state.lambda_f * trellis.sin_2theta));
        }
        if constexpr (F.paper() || F.lateral) turn += abs(state.m);
        if constexpr (F.lateral) {
            const Real E2 = state.alpha * (c.lateral_modulus * c.effective_thickness);
            const Real G12 = state.alpha * (c.shear_modulus * c.effective_thickness);
            Real stretch = E2;
            if constexpr (F.unequal) stretch = E2 * (2.0 * max(fill.share, warp.share));
            k.angle = 2.0 * E2 * cot * cot + G12;
            if constexpr (F.paper()) {
                stretch += 3.0 * G12 * cot * cot;
                k.angle += 2.0 * G12;
            } else {
                const Real rate =
                    select(state.alpha > 0.0, Real((0.5 / c.transition) / state.alpha), Real(0.0));
                const Real p = abs(state.p_f) + abs(state.p_w);
                stretch += 0.5 * rate * p;
                k.angle += rate * (cot * p + abs(state.q) + 0.5 * p) + p * inverse_sine * inverse_sine;
            }
            const Real inverse = max(inverse_f, inverse_w);
            k.lateral = stretch * inverse * inverse;
        }
        if constexpr (F.friction && !F.paper()) {
            const double per_cell = 1 / cell_area<F>(c);
            k.angle += state.friction_limit * (per_cell * 0.5 / stick_angle);
            turn += abs(state.friction_moment) * (2.0 * per_cell);
        }
        if constexpr (F.friction && F.paper()) turn += abs(state.friction_turn);
        k.angle += 0.5 * turn * (cot + inverse_sine);
        cot_psi = trellis.cos_2theta * inverse_sine;
        inverse_sin = inverse_sine;
    }
    Real packing_f = 0.0, packing_w = 0.0;
    if constexpr (F.lateral && !F.paper()) {
        packing_f = state.p_w;
        packing_w = state.p_f;
    }
    // N holds yarn and packing forces, which may cancel: count them apart
    const Real n_f = abs(state.N_f * state.lambda_f - packing_f) + abs(packing_f);
    const Real n_w = abs(state.N_w * state.lambda_w - packing_w) + abs(packing_w);
    k.yarn_f += (n_f + 0.5 * turn) * inverse_f * inverse_f;
    k.yarn_w += (n_w + 0.5 * turn) * inverse_w * inverse_w;
    if constexpr (F.paper()) {
        const Real tilting = 0.5 * turn * (abs(cot_psi) + inverse_sin);
        k.normal = {(n_f + tilting) * inverse_f * inverse_f, 0.0, (n_w + tilting) * inverse_w * inverse_w};
    } else {
        if constexpr (F.lateral) Q += 0.5 * state.m;
        if constexpr (F.friction) Q += state.friction_moment * (1 / cell_area<F>(c));
        k.normal = {(state.N_f * state.lambda_f + Q * cot_psi) * inverse_f * inverse_f,
                    -Q * inverse_sin * inverse_f * inverse_w,
                    (state.N_w * state.lambda_w + Q * cot_psi) * inverse_w * inverse_w};
    }
    return k;
}

}  // namespace weavefront::fabric
