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

/// I_w/A of the rhombus in which the yarns touch, m: mean distance from its centre, IT04 (43),(45). Beyond
/// locking, where the printed formulas grow without bound, its value at locking.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real friction_arm(const Constants& c, Trellis<Real> trellis) {
    if (any(abs(trellis.cos_2theta) > c.packed_cos_2theta))
        trellis =
            trellis_of(clamp(trellis.cos_2theta, Real(-c.packed_cos_2theta), Real(c.packed_cos_2theta)));
    const Real co = trellis.cos_theta, si = trellis.sin_theta;
    const Real sc = si * co;
    // tan(45 deg + theta/2)/tan(theta/2) = (1 + sin)(1 + cos)/(sin cos); cos/sin^2 + sin/cos^2 = (cos^3 +
    // sin^3)/(sin cos)^2
    const Real logarithm = log_far_ratio(Real((1.0 + si) * (1.0 + co)), sc);  // never below ln 5.8
    return c.width * (1.0 / 12.0) * trellis.sin_2theta *
           (logarithm + (co * co * co + si * si * si) / (sc * sc));
}

/// The smaller positive one of two forces, zero when neither is.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real smaller_positive(const Real& a, const Real& b) {
    const Real smaller = select((a > 0.0) & (a < b), a, b);
    return max(Real(0.0), select(b > 0.0, smaller, a));
}

/// Friction moment at full slip, M = mu <2 F/A> I_w, IT04 (44), N m. @param F force with which the yarns
/// press on each other, N
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real slip_moment(const Constants& c, const Real& F,
                                                 const Trellis<Real>& trellis) {
    return 2.0 * c.friction * F * friction_arm(c, trellis);
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
    const Real size = 2.0 * J * M * sign * (1 / (c.span * c.span));
    return {-size * now.sin_theta, size * now.cos_theta, Real(0.0)};
}

}  // namespace weavefront::fabric
