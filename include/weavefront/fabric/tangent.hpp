#pragma once
/// @file
/// The cell's tangent in the plane, sharper than `stiffness_bound` and dearer: for the element that decides on the time step.

#include <array>

#include "weavefront/fabric/friction.hpp"
#include "weavefront/fabric/lateral.hpp"

namespace weavefront::fabric {

/// Second variation of the energy per reference area, N/m, in the changes of the yarn vectors.
struct Tangent {
    /// In the plane, N/m: of dg_f along and across the fill, of dg_w along and across the warp; across is a quarter turn from fill to warp
    /// on.
    std::array<std::array<double, 4>, 4> plane{};
    std::array<double, 3> normal{};  ///< out of the plane: {fill fill, fill warp, warp warp}, N/m
    double cosine = 0, sine = 1;     ///< of the angle psi from fill to warp
};

/// The consistent formulation's instantaneous tangent with every crossover held, which bounds it from above: letting one go only softens,
/// and a yarn that straightens is held from one step to the next.
///
/// With x = dg/lambda along and y across each yarn, d ln lambda = x and d psi = y_w - y_f to first order; to second order
/// ln lambda adds y^2 - x^2, psi 2 (x_f y_f - x_w y_w), and out of the plane z the two give z^2 and cot psi (z_f^2 + z_w^2) -
/// 2 z_f z_w/sin psi. Packing: dp_f = E (x_w + cot psi dpsi), dp_w = E (x_f + cot psi dpsi), dq = G dpsi; in the transition, what
/// unpacks lets go p and q at a rate 1/(2 alpha Dtheta), which counts as a spring of that stiffness.
/// @return per reference area, N/m
template <Features F>
[[nodiscard]] Tangent tangent_bound(const Constants& c, const State<double>& state) {
    const double yarn = c.instant_modulus * c.area / c.span * (0.5 * c.span * c.inverse_length);
    double stretch_f = yarn * state.lambda_f * state.lambda_f, stretch_w = yarn * state.lambda_w * state.lambda_w;
    if constexpr (F.failure) stretch_f *= state.intact_f, stretch_w *= state.intact_w;
    const double n_f = state.N_f * state.lambda_f, n_w = state.N_w * state.lambda_w;
    double cosine = 0, sine = 1, Q = 0, angle = 0, E = 0, p_f = 0, p_w = 0;
    if constexpr (F.follows_angle()) {
        const auto trellis = trellis_of(state.cos_2theta);
        cosine = trellis.cos_2theta, sine = trellis.sin_2theta;
    }
    const double cot = cosine / sine;
    if constexpr (F.lateral) {
        p_f = state.p_f, p_w = state.p_w;
        Q = 0.5 * state.m;
        E = state.alpha * (0.5 * c.lateral_modulus * c.effective_thickness);
        const double p = abs(p_f) + abs(p_w);
        const bool releases = state.alpha > 0 && abs(state.phi) <= c.locking_angle;
        const double rate = releases ? 0.5 / (c.transition * state.alpha) : 0.0;
        angle = 2 * E * cot * cot + state.alpha * c.shear_modulus * c.effective_thickness - (p_f + p_w) / (sine * sine) +
                rate * (abs(cot) * p + abs(state.q) + 0.5 * p);
        stretch_f += E + 0.5 * rate * p;
        stretch_w += E + 0.5 * rate * p;
    }
    if constexpr (F.friction) {
        const double per_cell = 1 / (c.span * c.span), lambda = max(state.lambda_f, state.lambda_w);
        angle += state.friction_limit * (0.5 * per_cell / stick_angle);
        Q += state.friction_moment * per_cell;
        // Stretch presses the yarns together, by S Ka (s/2L) sin beta cos beta lambda, and so raises the moment that they slip at. This
        // acts one way only; half of it is shared out to either side.
        const double pressing = c.area * c.instant_modulus * (0.5 * c.span * c.inverse_length) * min(0.5 * lambda, c.thickness / c.span);
        const double rubbing = slip_moment(c, pressing, trellis_of(cosine)) * per_cell;
        stretch_f += 0.5 * rubbing, stretch_w += 0.5 * rubbing, angle += 0.5 * rubbing;
    }
    // Along a yarn its tension counts with sin^2 beta <= 1 of the bars' slope.
    stretch_f += max(n_f - p_w, 0.0) - p_w;
    stretch_w += max(n_w - p_f, 0.0) - p_f;
    const double f = 1 / state.lambda_f, w = 1 / state.lambda_w, across = E * cot;
    Tangent t{.cosine = cosine, .sine = sine};
    t.plane = {{{stretch_f * f * f, (Q - across) * f * f, 0, across * f * w},
                {(Q - across) * f * f, (n_f + angle) * f * f, -across * f * w, -angle * f * w},
                {0, -across * f * w, stretch_w * w * w, (across - Q) * w * w},
                {across * f * w, -angle * f * w, (across - Q) * w * w, (n_w + angle) * w * w}}};
    t.normal = {(n_f + Q * cot) * f * f, -Q / sine * f * w, (n_w + Q * cot) * w * w};
    return t;
}

}  // namespace weavefront::fabric
