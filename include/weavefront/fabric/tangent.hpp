#pragma once
/// @file
/// The cell's tangent with its crossover free, sharper than `stiffness_bound` and dearer.

#include <array>

#include "weavefront/fabric/cell.hpp"

namespace weavefront::fabric {

/// Second variation of the energy per reference area in changes of the yarn vectors in their plane, N/m: of
/// dg_f along and across the fill, of dg_w along and across the warp; across is a quarter turn from fill to
/// warp on.
template <class Real>
using Tangent = std::array<std::array<Real, 4>, 4>;

/// Second variation of the yarns' energy per reference area in the two stretches.
template <class Real>
struct YarnTangent {
    Real fill, coupling, warp;  ///< N/m
    Real crossover;             ///< force with which the yarns press on each other, N
};

/// The yarns' instantaneous tangent with the crossover where it balances them, free to move: what holds it,
/// W_dd, is taken out of the stretches, W_ll - W_ld W_ld/W_dd. Per bar of slope beta, W_ll = (k cos^2 + g
/// sin^2)/2, W_ld = (k - g) sin cos/s and W_dd = 2 (k sin^2 + g cos^2)/s^2 with k = S Ka/L and the tension's
/// g = S sigma/L_f. A crossover at the end of its way, or one that compression makes unstable, counts as
/// held: W_ll alone.
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE YarnTangent<Real> yarn_tangent(const Constants& c, const State<Real>& state) {
    const double bar = c.fill.instant_modulus * c.fill.area * c.fill.inverse_length;
    Real k_f = bar, k_w = bar;
    if constexpr (F.failure) {
        k_f *= state.intact_f;
        k_w *= state.intact_w;
    }
    if constexpr (!F.crimp) return {0.5 * k_f, 0.0, 0.5 * k_w, 0.0};
    const double half_span = 0.5 * c.fill.span, half_thickness = 0.5 * c.thickness;
    const BarLengths<Real> L = bar_lengths<F>(c, state);
    const YarnState<Real> yarns = yarn_state<F>(c, state);
    const Real inverse = 1.0 / (L.fill * L.warp), inverse_f = L.warp * inverse, inverse_w = L.fill * inverse;
    const Real cos_f = state.lambda_f * half_span * inverse_f, sin_f = state.h_f * inverse_f;
    const Real cos_w = state.lambda_w * half_span * inverse_w,
               sin_w = (half_thickness - state.h_f) * inverse_w;
    const Real g_f = c.fill.area * yarns.sigma_f * inverse_f, g_w = c.fill.area * yarns.sigma_w * inverse_w;
    const Real lift_f = (k_f - g_f) * (sin_f * cos_f), lift_w = (k_w - g_w) * (sin_w * cos_w);
    const Real holds =
        (k_f * (sin_f * sin_f) + g_f * (cos_f * cos_f)) + (k_w * (sin_w * sin_w) + g_w * (cos_w * cos_w));
    const MaskOf<Real> is_free = (state.h_f > 0.0) & (state.h_f < half_thickness) & (holds > 0.0);
    const Real yields = select(is_free, Real(0.5 / holds), Real(0.0));
    return {0.5 * (k_f * (cos_f * cos_f) + g_f * (sin_f * sin_f)) - lift_f * lift_f * yields,
            lift_f * lift_w * yields,
            0.5 * (k_w * (cos_w * cos_w) + g_w * (sin_w * sin_w)) - lift_w * lift_w * yields,
            c.fill.area * smaller_positive(Real(yarns.sigma_f * sin_f), Real(yarns.sigma_w * sin_w))};
}

/// The consistent formulation's instantaneous tangent.
///
/// With x = dg/lambda along and y across each yarn, d ln lambda = x and d psi = y_w - y_f to first order; to
/// second order ln lambda adds y^2 - x^2 and psi 2 (x_f y_f - x_w y_w). Packing: dp_f = E (x_w + cot psi
/// dpsi), dp_w = E (x_f + cot psi dpsi), dq = G dpsi; in the transition, what unpacks lets go p and q at a
/// rate 1/(2 alpha Dtheta), which counts as a spring of that stiffness.
/// @return per reference area, N/m
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE Tangent<Real> tangent_bound(const Constants& c, const State<Real>& state) {
    const YarnTangent<Real> yarns = yarn_tangent<F>(c, state);
    Real stretch_f = yarns.fill * (state.lambda_f * state.lambda_f),
         stretch_w = yarns.warp * (state.lambda_w * state.lambda_w);
    const Real n_f = state.N_f * state.lambda_f, n_w = state.N_w * state.lambda_w;
    Real Q = 0.0, angle = 0.0, across = 0.0;
    if constexpr (F.lateral) {
        if (any(state.alpha > 0.0)) {
            const Trellis<Real> trellis = trellis_of(state.cos_2theta);
            const Real sine = trellis.sin_2theta, cot = trellis.cos_2theta / sine;
            const Real E = state.alpha * (0.5 * c.lateral_modulus * c.effective_thickness);
            const Real p = abs(state.p_f) + abs(state.p_w);
            const MaskOf<Real> releases = (state.alpha > 0.0) & (abs(state.phi) <= c.locking_angle);
            const Real rate = select(releases, Real(0.5 / (c.transition * state.alpha)), Real(0.0));
            Q = 0.5 * state.m;
            across = E * cot;
            angle = 2.0 * E * cot * cot + state.alpha * (c.shear_modulus * c.effective_thickness) -
                    (state.p_f + state.p_w) / (sine * sine) + rate * (abs(cot) * p + abs(state.q) + 0.5 * p);
            stretch_f += E + 0.5 * rate * p - state.p_w;
            stretch_w += E + 0.5 * rate * p - state.p_f;
        }
    }
    if constexpr (F.friction) {
        const double per_cell = 1 / (c.fill.span * c.fill.span);
        angle += state.friction_limit * (0.5 * per_cell / stick_angle);
        Q += state.friction_moment * per_cell;
        // Stretch presses the yarns together, by S Ka (s/2L) sin beta cos beta lambda at most, and so raises
        // in proportion the moment that acts. This goes one way only; half of it is shared out to either
        // side.
        const Real lambda = max(state.lambda_f, state.lambda_w);
        const Real pressing = c.fill.area * c.fill.instant_modulus *
                              (0.5 * c.fill.span * c.fill.inverse_length) *
                              min(Real(0.5 * lambda), Real(c.thickness / c.fill.span));
        const Real rubbing =
            select(yarns.crossover > 0.0,
                   Real(abs(state.friction_moment) * pressing / yarns.crossover * per_cell), Real(0.0));
        stretch_f += 0.5 * rubbing;
        stretch_w += 0.5 * rubbing;
        angle += 0.5 * rubbing;
    }
    const Real inverse = 1.0 / (state.lambda_f * state.lambda_w);
    const Real f = state.lambda_w * inverse, w = state.lambda_f * inverse;
    const Real ff = f * f, fw = f * w, ww = w * w;
    return {{{stretch_f * ff, (Q - across) * ff, yarns.coupling, across * fw},
             {(Q - across) * ff, (n_f + angle) * ff, -across * fw, -angle * fw},
             {yarns.coupling, -across * fw, stretch_w * ww, (across - Q) * ww},
             {across * fw, -angle * fw, (across - Q) * ww, (n_w + angle) * ww}}};
}

}  // namespace weavefront::fabric
