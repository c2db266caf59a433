#pragma once
/// @file
/// One step of the cell, the material point of a fabric: IT04 section 2 from the yarns' stretches and angle
/// to the stress.

#include "weavefront/fabric/crimp.hpp"
#include "weavefront/fabric/friction.hpp"
#include "weavefront/fabric/lateral.hpp"

namespace weavefront::fabric {

/// Shortest and longest yarn stretch that the kernel takes literally; beyond them its products would leave
/// the range of a double.
inline constexpr double smallest_stretch = 1e-40, largest_stretch = 1e40;

/// What the cell pulls with: Kirchhoff resultants t_e tau per reference area in the bisector frame, N/m, and
/// that frame.
template <class Real>
struct Response {
    Real T_xx, T_yy, T_xy;      ///< N/m
    Real sin_theta, cos_theta;  ///< of half the angle between the yarns
};

/// Yarns at the end of a step, as far as the stress needs them.
template <class Real>
struct YarnForces {
    Real cos_beta_f, cos_beta_w;  ///< of the bars' slopes, 1
    Real crossover;               ///< force with which the yarns press on each other, N
};

/// The undeformed cell: each crossover at half its height, nothing stressed.
template <Features F, class Real>
[[nodiscard]] State<Real> initial_state(const Constants& c) {
    State<Real> state;
    if constexpr (F.crimp) state.h_f = c.fill.height;
    if constexpr (F.lateral) state.alpha = contact_factor(c, state.phi);
    return state;
}

/// Lengths of the bars of a state.
template <class Real>
struct BarLengths {
    Real fill, warp;  ///< m
};

template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE BarLengths<Real> bar_lengths(const Constants& c, const State<Real>& state) {
    const Real a_f = state.lambda_f * (0.5 * c.fill.span), a_w = state.lambda_w * (0.5 * warp_of<F>(c).span);
    if constexpr (!F.crimp) return {a_f, a_w};
    return {bar_length(a_f, state.h_f), bar_length(a_w, Real(0.5 * c.thickness - state.h_f))};
}

/// Axial strain and stress of the yarns of a state, for output.
template <class Real>
struct YarnState {
    Real eps_f, eps_w;      ///< 1
    Real sigma_f, sigma_w;  ///< Pa
};

template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE YarnState<Real> yarn_state(const Constants& c, const State<Real>& state) {
    const BarLengths<Real> L = bar_lengths<F>(c, state);
    const YarnConstants &fill = c.fill, &warp = warp_of<F>(c);
    const Real eps_f = (L.fill - fill.length) * fill.inverse_length,
               eps_w = (L.warp - warp.length) * warp.inverse_length;
    if constexpr (F.viscous) return {eps_f, eps_w, state.sigma_f, state.sigma_w};
    return {eps_f, eps_w, fill.static_modulus * eps_f * state.intact_f,
            warp.static_modulus * eps_w * state.intact_w};
}

/// Height of the fill's crossover at the end of the step (consistent), m.
template <Features F, class Real, class Search>
[[nodiscard]] WEAVEFRONT_INLINE Real crossover_height(const Bars<Real>& bars, const State<Real>& state,
                                                      double half_thickness, Search search) {
    const auto balanced = [&](const Bars<Real>& yarns) __attribute__((always_inline)) {
        const Real delta = balance_crossover(EndBalance<Real>{yarns}, Real(-yarns.h_f), yarns.h_w,
                                             half_thickness, nullptr, search);
        return clamp(Real(yarns.h_f + delta), Real(0.0), Real(half_thickness));  // (36)
    };
    if constexpr (F.failure) {
        const Real whole = state.intact_f * state.intact_w;
        if (any(whole < 1.0)) {
            Bars<Real> whole_cells = bars;  // elsewhere nothing is to be sought
            for (auto* law : {&whole_cells.law_f, &whole_cells.law_w})
                law->offset *= whole, law->slope *= whole;
            const Real height = balanced(whole_cells);
            const Real of_fill =
                select(state.intact_f > 0.0, lone_height(bars.a_f, bars.law_f, half_thickness), height);
            const Real of_warp = Real(half_thickness) - lone_height(bars.a_w, bars.law_w, half_thickness);
            return select(whole < 1.0, select(state.intact_w > 0.0, of_warp, of_fill), height);
        }
    }
    return balanced(bars);
}

/// The bars with stresses that balance where the forces do: those of the warp count S_w/S_f times, so that
/// (29) reads h_f/L_f sigma_f = h_w/L_w sigma_w as in the cell of equal yarns.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Bars<Real> with_forces(const Constants& c, Bars<Real> bars) {
    const double ratio = c.warp.area / c.fill.area;
    bars.law_w.offset *= ratio;
    bars.law_w.slope *= ratio;
    return bars;
}

/// Brings the yarns to the end of the step: crimp interchange, stress, failure; IT04 (18)-(36).
/// @param state crossover height, stresses and intact flags are updated; the stretches are still those of the
/// start
template <Features F, class Real, class Search>
WEAVEFRONT_INLINE YarnForces<Real> advance_yarns(const Constants& c, const Step& step, State<Real>& state,
                                                 const Real& lambda_f, const Real& lambda_w, Search search) {
    const YarnConstants &fill = c.fill, &warp = warp_of<F>(c);
    const double half_span_f = 0.5 * fill.span, half_span_w = 0.5 * warp.span;
    const double half_thickness = 0.5 * c.thickness;
    const BarLengths<Real> before = bar_lengths<F>(c, state);
    const Bars<Real> bars{
        .a_f = lambda_f * half_span_f,
        .a_w = lambda_w * half_span_w,
        .h_f = state.h_f,
        .h_w = half_thickness - state.h_f,
        .law_f = axial_law<F>(fill, step.fill, state.sigma_f, before.fill, state.intact_f),
        .law_w = axial_law<F>(warp, warp_of<F>(step), state.sigma_w, before.warp, state.intact_w)};
    Real L_f = bars.a_f, L_w = bars.a_w;
    YarnForces<Real> result{.cos_beta_f = 1.0, .cos_beta_w = 1.0, .crossover = 0.0};
    if constexpr (F.crimp && F.paper()) {
        const YarnState<Real> old = yarn_state<F>(c, state);
        const MidBalance<Real> balance{.bars = bars,
                                       .a_mid_f = 0.5 * (state.lambda_f + lambda_f) * half_span_f,
                                       .a_mid_w = 0.5 * (state.lambda_w + lambda_w) * half_span_w,
                                       .sigma_f = old.sigma_f,
                                       .sigma_w = old.sigma_w};
        const Real delta =
            balance_crossover(balance, Real(-bars.h_f), bars.h_w, half_thickness, nullptr, search);
        state.h_f = clamp(Real(bars.h_f + delta), Real(0.0), Real(half_thickness));  // (36)
        if constexpr (F.friction)
            result.crossover =
                fill.area * smaller_positive(balance.fill(delta).force, balance.warp(delta).force);
    } else if constexpr (F.crimp) {
        if constexpr (F.unequal)
            state.h_f = crossover_height<F>(with_forces(c, bars), state, half_thickness, search);
        else
            state.h_f = crossover_height<F>(bars, state, half_thickness, search);
    }
    if constexpr (F.crimp) {
        L_f = bar_length(bars.a_f, state.h_f);
        L_w = bar_length(bars.a_w, Real(half_thickness - state.h_f));
    }
    state.sigma_f = bars.law_f.stress(L_f);
    state.sigma_w = bars.law_w.stress(L_w);
    if constexpr (F.crimp && !F.paper()) {
        const Real inverse = 1.0 / (L_f * L_w);
        const Real inverse_f = L_w * inverse, inverse_w = L_f * inverse;
        result.cos_beta_f = bars.a_f * inverse_f;
        result.cos_beta_w = bars.a_w * inverse_w;
        if constexpr (F.friction) {
            const Real press_f = state.sigma_f * state.h_f * inverse_f;
            Real press_w = state.sigma_w * (half_thickness - state.h_f) * inverse_w;
            if constexpr (F.unequal) press_w *= warp.area / fill.area;
            result.crossover = fill.area * smaller_positive(press_f, press_w);
        }
    }
    if constexpr (F.failure) {
        break_yarn<F>(fill, L_f, state.sigma_f, state.intact_f, state.weakness_f);
        break_yarn<F>(warp, L_w, state.sigma_w, state.intact_w, state.weakness_w);
    }
    return result;
}

/// Stress as printed but for friction, IT04 (39)-(42),(48), times t_e J: resultants in the bisector frame,
/// N/m.
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE PlaneTensor<Real> stress_as_printed(const Constants& c, State<Real>& state,
                                                                    const Real& lambda_f,
                                                                    const Real& lambda_w,
                                                                    const Trellis<Real>& now, const Real& J) {
    if constexpr (F.lateral) {
        const Trellis<Real> before = trellis_of(state.cos_2theta);
        pack_yarns_as_printed(
            c, state, strain_increment(state.lambda_f, state.lambda_w, before, lambda_f, lambda_w, now), now);
    }
    const double share = 2.0 * c.fill.area / (c.fill.span * c.effective_thickness);  // (39)
    const PlaneTensor<Real> fill = to_bisector_frame(Real(share * state.sigma_f), state.sigma_22_f,
                                                     state.sigma_12_f, now.cos_theta, now.sin_theta);
    const PlaneTensor<Real> warp = to_bisector_frame(Real(share * state.sigma_w), state.sigma_22_w,
                                                     state.sigma_12_w, now.cos_theta, Real(-now.sin_theta));
    const Real scale = 0.5 * c.effective_thickness * J;
    return {scale * (fill.xx + warp.xx), scale * (fill.yy + warp.yy), scale * (fill.xy + warp.xy)};
}

/// Adds the work of a step, trapezoidal in time: mean force times change of its conjugate.
/// @param n forces at the end of the step, without friction; @param friction those of friction
/// @param friction_before those of friction at its start
template <Features F, class Real>
WEAVEFRONT_INLINE void add_work(State<Real>& state, const Real& lambda_f, const Real& lambda_w,
                                const Real& dtheta, const Forces<Real>& n, const Forces<Real>& friction,
                                const Forces<Real>& friction_before) {
    const Real dlambda_f = lambda_f - state.lambda_f, dlambda_w = lambda_w - state.lambda_w;
    const Real inverse = 1.0 / (lambda_f * lambda_w);
    const Real per_f = lambda_w * inverse, per_w = lambda_f * inverse;
    const Real N_f = n.fill * per_f, N_w = n.warp * per_w;
    Real twice = (state.N_f + N_f) * dlambda_f + (state.N_w + N_w) * dlambda_w;
    if constexpr (F.paper() || F.lateral) twice += (state.m + n.angle) * dtheta;
    state.work += 0.5 * twice;
    state.N_f = N_f;
    state.N_w = N_w;
    state.m = n.angle;
    if constexpr (F.friction) {
        Real spent = (friction_before.angle + friction.angle) * dtheta;
        if constexpr (F.paper()) {
            spent += (friction_before.fill / state.lambda_f + friction.fill * per_f) * dlambda_f;
            spent += (friction_before.warp / state.lambda_w + friction.warp * per_w) * dlambda_w;
        }
        state.friction_work += 0.5 * spent;
    }
}

/// Advances the cell by one step and returns its resultants.
/// Work per reference area is added up in `state`, that of friction apart.
/// @param c, step     of the fabric and the time step
/// @param state       of the start on entry, of the end on return; a yarn that breaks carries nothing from
/// this step's end on
/// @param lambda_f, lambda_w stretches of the yarn spans at the end of the step, positive
/// @param cos_2theta  cosine of the angle between the yarns at the end of the step, d_f . d_w
/// @param search      of the crimp equilibrium
template <Features F, class Real, class Search = StatedSearch>
WEAVEFRONT_INLINE Response<Real> advance(const Constants& c, const Step& step, State<Real>& state,
                                         Real lambda_f, Real lambda_w, Real cos_2theta, Search search = {}) {
    lambda_f = clamp(lambda_f, Real(smallest_stretch), Real(largest_stretch));
    lambda_w = clamp(lambda_w, Real(smallest_stretch), Real(largest_stretch));
    const Trellis<Real> now = trellis_of(cos_2theta);
    const Real J = lambda_f * lambda_w * now.sin_2theta;
    Real dtheta = 0.0;
    if constexpr (F.follows_angle()) {
        const Real phi = angle_from_45(now);
        dtheta = phi - state.phi;
        state.phi = phi;
    }
    const YarnForces<Real> yarns = advance_yarns<F>(c, step, state, lambda_f, lambda_w, search);

    Forces<Real> n, friction, friction_before;
    PlaneTensor<Real> T;
    if constexpr (F.paper()) {
        T = stress_as_printed<F>(c, state, lambda_f, lambda_w, now, J);
        n = forces(T, now);
        if constexpr (F.friction) {
            friction_before = {state.friction_stretch, state.friction_stretch, state.friction_turn};
            const PlaneTensor<Real> rubbing =
                friction_as_printed(c, slip_moment<F>(c, yarns.crossover, now), now, dtheta, J);
            T.xx += rubbing.xx;
            T.yy += rubbing.yy;
            friction = forces(rubbing, now);
            state.friction_stretch = friction.fill;
            state.friction_turn = friction.angle;
        }
    } else {
        const YarnConstants& warp = warp_of<F>(c);
        n.fill = (c.fill.area / warp.span) * state.sigma_f * yarns.cos_beta_f * lambda_f;
        n.warp = (warp.area / c.fill.span) * state.sigma_w * yarns.cos_beta_w * lambda_w;
        if constexpr (F.lateral) pack_yarns<F>(c, state, lambda_f, lambda_w, now, dtheta, n);
        Forces<Real> all = n;
        if constexpr (F.friction) {
            const double per_cell = 2.0 / cell_area<F>(c);
            friction_before.angle = per_cell * state.friction_moment;
            turn_with_friction(state, slip_moment<F>(c, yarns.crossover, now), dtheta);
            friction.angle = per_cell * state.friction_moment;
            all.angle += friction.angle;
        }
        T = resultants(all, now);
    }
    add_work<F>(state, lambda_f, lambda_w, dtheta, n, friction, friction_before);
    state.lambda_f = lambda_f;
    state.lambda_w = lambda_w;
    state.cos_2theta = now.cos_2theta;
    return {T.xx, T.yy, T.xy, now.sin_theta, now.cos_theta};
}

}  // namespace weavefront::fabric
