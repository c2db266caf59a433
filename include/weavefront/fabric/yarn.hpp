#pragma once
/// @file
/// A yarn: three-element viscoelasticity and rate-dependent failure, IT04 section 2.3.

#include "weavefront/fabric/constants.hpp"
#include "weavefront/simd/real.hpp"

namespace weavefront::fabric {

using namespace simd;

/// Axial stress at the end of a step as a function of the bar's length then: offset + slope (length -
/// reference).
template <class Real>
struct AxialLaw {
    Real offset;     ///< Pa
    Real slope;      ///< Pa/m
    Real reference;  ///< m

    [[nodiscard]] WEAVEFRONT_INLINE Real stress(const Real& length) const {
        return offset + slope * (length - reference);
    }
};

/// IT04 (18), or its exact counterpart (see step_of), with deps = (L^{n+1} - L^n)/L of (33).
/// @param sigma  stress at the start of the step, Pa
/// @param length bar length at the start of the step, m
/// @param intact 1, or 0 for a broken yarn, which carries no force
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE AxialLaw<Real> axial_law(const YarnConstants& c, const YarnStep& step,
                                                         const Real& sigma, const Real& length,
                                                         const Real& intact) {
    AxialLaw<Real> law{.offset = 0.0, .slope = step.modulus * c.inverse_length, .reference = c.length};
    if constexpr (F.viscous) {
        const Real eps = (length - c.length) * c.inverse_length;
        law.offset = sigma + step.relaxed * (c.static_modulus * eps - sigma);
        law.reference = length;
    }
    if constexpr (F.failure) {
        law.offset *= intact;
        law.slope *= intact;
    }
    return law;
}

/// How far a yarn is from its two failure criteria: each fails where it is above 1.
template <class Real>
struct FailureIndex {
    Real primary;    ///< eps_a/eps_a_max, IT04 (19)
    Real secondary;  ///< eps_b/eps_b_max, IT04 (20)
};

/// IT04 (19),(20). @param eps, sigma axial strain and stress of the yarn, 1 and Pa
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE FailureIndex<Real> failure_index(const YarnConstants& c, const Real& eps,
                                                                 const Real& sigma) {
    return {sigma * c.inverse_primary_stress, (c.hooke_modulus * eps - sigma) * c.inverse_secondary_stress};
}

/// Breaks the yarn where a criterion is exceeded by the updated values: from this step's stress on it carries
/// no axial force.
/// @param length bar length, m
/// @param sigma  stress, Pa; 0 on return where broken
/// @param intact 0 on return where broken
/// @param weakness failure strains of the fabric over those of the yarn, 1; with `Features::scatter`
template <Features F, class Real>
WEAVEFRONT_INLINE void break_yarn(const YarnConstants& c, const Real& length, Real& sigma, Real& intact,
                                  const Real& weakness) {
    FailureIndex<Real> index = failure_index(c, Real((length - c.length) * c.inverse_length), sigma);
    if constexpr (F.scatter) {
        index.primary *= weakness;
        index.secondary *= weakness;
    }
    const MaskOf<Real> broken = (index.primary > 1.0) | (index.secondary > 1.0);
    sigma = select(broken, Real(0.0), sigma);
    intact = select(broken, Real(0.0), intact);
}

}  // namespace weavefront::fabric
