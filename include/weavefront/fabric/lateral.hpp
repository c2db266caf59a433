#pragma once
/// @file
/// Yarns that touch sideways: the lateral contact factor and the packing stresses, IT04 section 2.4 and
/// figure 8.

#include "weavefront/fabric/constants.hpp"
#include "weavefront/fabric/state.hpp"
#include "weavefront/fabric/trellis.hpp"

namespace weavefront::fabric {

/// Lateral contact factor alpha, IT04 figure 8: 0 in the open trellis, 1 from the locking angle on, linear
/// over the transition before it.
/// @param phi braid angle from 45 deg, rad; the factor is the same on both sides
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real contact_factor(const Constants& c, const Real& phi) {
    return clamp(Real(1.0 + (abs(phi) - c.locking_angle) * (1 / c.transition)), Real(0.0), Real(1.0));
}

/// Packing forces of the consistent formulation: added to the yarns' in `n`, alone on the angle. The spacing
/// strains of fill and warp are e_f = ln(lambda_w sin 2 theta) and e_w = ln(lambda_f sin 2 theta). What
/// unpacks first lets go its share of the forces, min(1, alpha^{n+1}/alpha^n), so that an open trellis keeps
/// none: IT04 (40),(41) would leave them frozen in.
/// @param state at the start of the step but for phi, which is new; alpha, p_f, p_w, q are brought to its end
/// @param dtheta change of the braid angle, rad
template <Features F, class Real>
WEAVEFRONT_INLINE void pack_yarns(const Constants& c, State<Real>& state, const Real& lambda_f,
                                  const Real& lambda_w, const Trellis<Real>& now, const Real& dtheta,
                                  Forces<Real>& n) {
    const Real alpha =
        contact_factor(c, state.phi) * (state.intact_f * state.intact_w);  // a broken yarn leaves room
    const MaskOf<Real> packed = alpha > 0.0;
    Real p_f = 0.0, p_w = 0.0, q = 0.0;
    if (any(packed)) {
        const Real kept = select(alpha < state.alpha, Real(alpha / state.alpha), Real(1.0));
        Real of_fill = alpha * (0.5 * c.lateral_modulus * c.effective_thickness), of_warp = of_fill;
        if constexpr (F.unequal) {
            of_fill = alpha * (c.fill.share * c.lateral_modulus * c.effective_thickness);
            of_warp = alpha * (c.warp.share * c.lateral_modulus * c.effective_thickness);
        }
        const Trellis<Real> before = trellis_of(state.cos_2theta);
        const Real de_f =
            log_ratio(Real(lambda_w * now.sin_2theta), Real(state.lambda_w * before.sin_2theta));
        const Real de_w =
            log_ratio(Real(lambda_f * now.sin_2theta), Real(state.lambda_f * before.sin_2theta));
        p_f = select(packed, Real(state.p_f * kept + of_fill * de_f), p_f);
        p_w = select(packed, Real(state.p_w * kept + of_warp * de_w), p_w);
        q = select(packed,
                   Real(state.q * kept + alpha * (2.0 * c.shear_modulus * c.effective_thickness) * dtheta),
                   q);
        n.angle = 2.0 * (now.cos_2theta / now.sin_2theta) * (p_f + p_w) + 2.0 * q;
        n.angle = select(packed, n.angle, Real(0.0));
    }
    state.p_f = p_f;
    state.p_w = p_w;
    state.q = q;
    state.alpha = alpha;
    n.fill += p_w;
    n.warp += p_f;
}

/// Lateral and shear stresses in the yarns' axes as printed, IT04 (40),(41). @param strain increment of the
/// step, bisector frame
template <class Real>
WEAVEFRONT_INLINE void pack_yarns_as_printed(const Constants& c, State<Real>& state,
                                             const PlaneTensor<Real>& strain, const Trellis<Real>& now) {
    const Real whole = state.intact_f * state.intact_w;  // a broken yarn leaves room
    state.alpha = contact_factor(c, state.phi) * whole;
    const Real E2 = state.alpha * c.lateral_modulus;
    const Real G12 = state.alpha * c.shear_modulus;
    const LateralStrain<Real> fill = lateral_strain(strain, now.cos_theta, now.sin_theta);
    const LateralStrain<Real> warp = lateral_strain(strain, now.cos_theta, Real(-now.sin_theta));
    state.sigma_22_f = (state.sigma_22_f + E2 * fill.eps_22) * whole;
    state.sigma_12_f = (state.sigma_12_f + G12 * fill.gamma_12) * whole;
    state.sigma_22_w = (state.sigma_22_w + E2 * warp.eps_22) * whole;
    state.sigma_12_w = (state.sigma_12_w + G12 * warp.gamma_12) * whole;
}

}  // namespace weavefront::fabric
