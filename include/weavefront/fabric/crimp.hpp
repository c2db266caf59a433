#pragma once
/// @file
/// Crimp interchange: the crossover moves until fill and warp press on each other equally, IT04 (23)-(36).

#include "weavefront/fabric/constants.hpp"
#include "weavefront/fabric/yarn.hpp"

namespace weavefront::fabric {

/// One bar of each yarn while the crossover is sought; the heights are those before the step.
template <class Real>
struct Bars {
    Real a_f, a_w;  ///< half spans at the end of the step, lambda s/2, m
    Real h_f, h_w;  ///< crossover heights, m
    AxialLaw<Real> law_f, law_w;
};

/// Length of a bar of half span `a` whose ends differ in height by `h`, IT04 (25),(26).
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real bar_length(const Real& a, const Real& h) {
    return sqrt(a * a + h * h);
}

/// F_f - F_w up to a positive factor, and the Newton step (F_f - F_w)/d(F_f - F_w)/ddelta that it asks delta
/// to give up.
template <class Real>
struct Imbalance {
    Real force;   ///< only its sign and its zero count: N (EndBalance, cleared of denominators) or Pa
                  ///< (MidBalance)
    Real newton;  ///< m
};

/// Height of the crossover of a yarn whose partner is broken: nothing presses on it, so it lies where the
/// yarn carries nothing, or as near to that as the heights allow: taut at 0, compressed at t/2. (29) has a
/// second root at 0 wherever the yarn is slack, at which no yarn stays.
/// @param a half span at the end of the step, m
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real lone_height(const Real& a, const AxialLaw<Real>& law,
                                                 double half_thickness) {
    const Real slack_length = max(Real(law.reference - law.offset / law.slope), Real(0.0));
    return min(sqrt(max(Real(slack_length * slack_length - a * a), Real(0.0))), half_thickness);
}

/// (29) at the end of the step (consistent), cleared of denominators as IT04 (35): one division per
/// evaluation.
template <class Real>
struct EndBalance {
    Bars<Real> bars;

    [[nodiscard]] WEAVEFRONT_INLINE Imbalance<Real> operator()(const Real& delta) const {
        const Real h_f = bars.h_f + delta, h_w = bars.h_w - delta;
        const Real aa_f = bars.a_f * bars.a_f, aa_w = bars.a_w * bars.a_w;
        const Real hh_f = h_f * h_f, hh_w = h_w * h_w;
        const Real LL_f = aa_f + hh_f, LL_w = aa_w + hh_w;
        const Real L_f = sqrt(LL_f), L_w = sqrt(LL_w);
        const Real sigma_f = bars.law_f.stress(L_f), sigma_w = bars.law_w.stress(L_w);
        // dF/dh = sigma a^2/L^3 + slope h^2/L^2 for F = sigma h/L
        const Real stiff_f = sigma_f * aa_f + bars.law_f.slope * hh_f * L_f;
        const Real stiff_w = sigma_w * aa_w + bars.law_w.slope * hh_w * L_w;
        const Real force = h_f * sigma_f * L_w - h_w * sigma_w * L_f;
        return {force, force * (LL_f * LL_w) / (stiff_f * (LL_w * L_w) + stiff_w * (LL_f * L_f))};
    }
};

/// (29) at the middle of the step, IT04 (25)-(28) with the heights h_f + delta/2 and h_w - delta/2 (paper).
template <class Real>
struct MidBalance {
    Bars<Real> bars;
    Real a_mid_f, a_mid_w;  ///< half spans at mid-step, m
    Real sigma_f, sigma_w;  ///< stresses at the start of the step, Pa

    /// F/S at mid-step and its derivative by the rise of the crossover.
    struct Lift {
        Real force;  ///< Pa
        Real rate;   ///< Pa/m
    };

    /// @param d rise of this yarn's crossover over the step, m
    [[nodiscard]] WEAVEFRONT_INLINE static Lift lift(const Real& a_mid, const Real& a, const Real& h,
                                                     const Real& d, const Real& sigma,
                                                     const AxialLaw<Real>& law) {
        const Real h_mid = h + 0.5 * d, h_end = h + d;
        const Real inverse_mid = 1.0 / bar_length(a_mid, h_mid);
        const Real L_end = bar_length(a, h_end);
        const Real sigma_mid = 0.5 * (sigma + law.stress(L_end));
        const Real sine = h_mid * inverse_mid, cosine = a_mid * inverse_mid;
        return {sine * sigma_mid,
                0.5 * (cosine * cosine * inverse_mid * sigma_mid + sine * law.slope * h_end / L_end)};
    }

    [[nodiscard]] WEAVEFRONT_INLINE Lift fill(const Real& delta) const {
        return lift(a_mid_f, bars.a_f, bars.h_f, delta, sigma_f, bars.law_f);
    }
    [[nodiscard]] WEAVEFRONT_INLINE Lift warp(const Real& delta) const {
        return lift(a_mid_w, bars.a_w, bars.h_w, Real(-delta), sigma_w, bars.law_w);
    }

    [[nodiscard]] WEAVEFRONT_INLINE Imbalance<Real> operator()(const Real& delta) const {
        const Lift f = fill(delta), w = warp(delta);
        const Real force = f.force - w.force;
        return {force, force / (f.rate + w.rate)};
    }
};

/// Newton steps tried before the search only halves its bracket.
inline constexpr int newton_limit = 16;
/// A Newton step below this part of t/2 is the last: convergence is quadratic, so it leaves an error of about
/// its square.
inline constexpr double newton_tolerance = 1e-8;
/// A bracket below this part of t/2 is at the rounding of the heights.
inline constexpr double bracket_tolerance = 1e-15;
/// No search takes more evaluations than this: the first, `newton_limit`, one at the bound, and 50 halvings
/// down to `bracket_tolerance`, 2^-50 < 1e-15.
inline constexpr int evaluation_limit = 1 + newton_limit + 1 + 50;

/// How exact the search is, as a type: the kernels know the stated tolerance when they are compiled. A study
/// may ask for another one.
struct StatedSearch {
    /// Last Newton step over t/2.
    [[nodiscard]] static constexpr double tolerance() { return newton_tolerance; }
    /// Receives the number of evaluations.
    static constexpr void count(int) {}
};

/// Change `delta` of the crossover height that balances the yarns, within [lower, upper] around zero.
/// The root is sought from delta = 0 towards the side to which the imbalance pushes. With both yarns in
/// tension the imbalance grows strictly with delta and the root is unique; otherwise, where the imbalance
/// keeps its sign up to the bound, the bound is the answer. Newton steps that leave the bracket become the
/// bound (once) or the middle of the bracket, so that neither compression nor a broken yarn can make the
/// search fail. Each lane goes its own way and freezes when it is done.
/// @param balance     EndBalance or MidBalance
/// @param lower, upper bounds of delta, m; lower <= 0 <= upper, upper - lower = t/2
/// @param half_thickness t/2, m
/// @param evaluations receives the number of evaluations of the slowest lane when not null
/// @param search      how exact
template <class Real, class Balance, class Search = StatedSearch>
[[nodiscard]] WEAVEFRONT_INLINE Real balance_crossover(const Balance& balance, const Real& lower,
                                                       const Real& upper, double half_thickness,
                                                       int* evaluations = nullptr, Search search = {}) {
    using Flags = MaskOf<Real>;
    Real delta = 0.0;
    Imbalance<Real> now = balance(delta);
    const Flags falls = now.force > 0.0;
    const Real bound = select(falls, lower, upper);
    Real low = select(falls, lower, Real(0.0));
    Real high = select(falls, Real(0.0), upper);
    Flags open = ((now.force > 0.0) | (now.force < 0.0)) & (low < high);
    Flags bound_untried = open;
    int count = 1;
    for (; any(open) && count < evaluation_limit; ++count) {
        const Real newton = delta - now.newton;
        Flags inside = (newton > low) & (newton < high);
        const Flags last = (inside & (abs(now.newton) <= search.tolerance() * half_thickness)) |
                           (high - low <= bracket_tolerance * half_thickness);
        if (count > newton_limit) inside = inside & last;
        const Flags at_bound = open & (!inside) & (!last) & bound_untried;
        const Real elsewhere = select(at_bound, bound, Real(0.5 * (low + high)));
        delta = select(open, select(inside, newton, elsewhere), delta);
        open = open & (!last);
        if (!any(open)) break;
        now = balance(delta);
        const Flags above = now.force > 0.0, below = now.force < 0.0;
        high = select(open & above, delta, high);
        low = select(open & below, delta, low);
        // no change of sign up to the bound: the bound is the answer, and so is a bound that balances
        const Flags same_sign = (falls & above) | ((!falls) & below);
        open = open & (above | below) & (!(at_bound & same_sign));
        bound_untried = bound_untried & (!at_bound);
    }
    if (evaluations) *evaluations = count;
    search.count(count);
    return delta;
}

}  // namespace weavefront::fabric
