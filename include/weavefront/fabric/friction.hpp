#pragma once
/// @file
/// Friction of the yarns turning on each other at the crossover, IT04 section 2.5.

#include "weavefront/fabric/constants.hpp"
#include "weavefront/fabric/state.hpp"
#include "weavefront/fabric/trellis.hpp"

namespace weavefront::fabric {

/// Turn over which the friction moment comes up to its limit while the yarns stick (consistent formulation),
/// rad.
inline constexpr double stick_angle = 1e-3;

/// Mean distance from the centre of the parallelogram in which a yarn of width w_f crosses one of width w_w,
/// m. It is 4 triangles with their apex in the centre. With d the distance of a side from the centre, u1 and
/// u2 its ends as seen from the foot of the perpendicular, and r1, r2 half the diagonals, the integral of the
/// distance over such a triangle is d/6 (u2 r2 - u1 r1) + d^3/6 ln((u2 + r2)/(u1 + r1)). With w_f = w_w it is
/// IT04 (45) over (43).
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real mean_distance(double w_f, double w_w, const Trellis<Real>& trellis) {
    const Real inverse = 1.0 / trellis.sin_2theta;
    const Real a = (0.5 * w_w) * inverse, b = (0.5 * w_f) * inverse;  // half the sides along fill and warp
    const Real along = 2.0 * a * b * trellis.cos_2theta, squares = a * a + b * b;
    const Real far = sqrt(squares + along), near = sqrt(squares - along);  // half the diagonals
    const auto triangle = [&](double width, const Real& half, const Real& other)
        __attribute__((always_inline)) {
        const double d = 0.5 * width;
        const Real shift = other * trellis.cos_2theta;
        const Real u2 = shift + half, u1 = shift - half;
        // (near + u1)(near - u1) = d^2
        return (d / 6) * (u2 * far - u1 * near) +
               (d * d * d / 6) * log_far_ratio(Real((far + u2) * (near - u1)), Real(d * d));
    };
    const Real integral = 2.0 * (triangle(w_f, a, b) + triangle(w_w, b, a));
    return integral * trellis.sin_2theta * (1 / (w_f * w_w));
}

/// I_w/A of the rhombus in which the yarns touch, m: mean distance from its centre, IT04 (43),(45). Beyond
/// locking, where the printed formulas grow without bound, its value at locking.
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real friction_arm(const Constants& c, Trellis<Real> trellis) {
    if (any(abs(trellis.cos_2theta) > c.packed_cos_2theta))
        trellis =
            trellis_of(clamp(trellis.cos_2theta, Real(-c.packed_cos_2theta), Real(c.packed_cos_2theta)));
    if constexpr (F.unequal) return mean_distance(c.fill.width, c.warp.width, trellis);
    const Real co = trellis.cos_theta, si = trellis.sin_theta;
    const Real sc = si * co;
    // tan(45 deg + theta/2)/tan(theta/2) = (1 + sin)(1 + cos)/(sin cos); cos/sin^2 + sin/cos^2 = (cos^3 +
    // sin^3)/(sin cos)^2
    const Real logarithm = log_far_ratio(Real((1.0 + si) * (1.0 + co)), sc);  // never below ln 5.8
    return c.fill.width * (1.0 / 12.0) * trellis.sin_2theta *
           (logarithm + (co * co * co + si * si * si) / (sc * sc));
}

/// The smaller positive one of two forces, zero when neither is.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real smaller_positive(const Real& a, const Real& b) {
    const Real smaller = select((a > 0.0) & (a < b), a, b);
    return max(Real(0.0), select(b > 0.0, smaller, a));
}

/// Friction moment at full slip, M = mu <2 F/A> I_w, IT04 (44), N m. @param force with which the yarns
/// press on each other, N
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real slip_moment(const Constants& c, const Real& force,
                                                 const Trellis<Real>& trellis) {
    if constexpr (F.unequal)
        if (c.friction == 0) return 0.0;
    return 2.0 * c.friction * force * friction_arm<F>(c, trellis);
}

/// Moment of the consistent formulation: follows the turn elastically and is returned to [-M, M]. Where M
/// falls the moment lets go its share first, so that what is stored while the yarns stick never grows by
/// itself.
/// @param M slip moment at the end of the step, N m
template <class Real>
WEAVEFRONT_INLINE void turn_with_friction(State<Real>& state, const Real& M, const Real& dtheta) {
    const Real kept = select(M < state.friction_limit, Real(M / state.friction_limit), Real(1.0));
    state.friction_moment =
        clamp(Real(state.friction_moment * kept + M * (dtheta * (1 / stick_angle))), Real(-M), M);
    state.friction_limit = M;
}

/// Friction stresses as printed, IT04 (46),(47), times t_e J: resultants in the bisector frame, N/m. @param J
/// area ratio
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE PlaneTensor<Real> friction_as_printed(const Constants& c, const Real& M,
                                                                      const Trellis<Real>& now,
                                                                      const Real& dtheta, const Real& J) {
    const Real sign = select(dtheta > 0.0, Real(1.0), select(dtheta < 0.0, Real(-1.0), Real(0.0)));
    const Real size = 2.0 * J * M * sign * (1 / (c.fill.span * c.fill.span));
    return {-size * now.sin_theta, size * now.cos_theta, Real(0.0)};
}

}  // namespace weavefront::fabric
