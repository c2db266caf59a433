#pragma once
/// @file
/// The trellis of fill and warp in its bisector frame, IT04 section 2.1.

#include "weavefront/simd/math.hpp"
#include "weavefront/simd/real.hpp"

namespace weavefront::fabric {

using namespace simd;

/// Yarn directions in the frame x ~ d_f + d_w, y ~ d_f - d_w: fill at +theta, warp at -theta.
template <class Real>
struct Trellis {
    Real cos_2theta, sin_2theta;
    Real cos_theta, sin_theta;
};

/// Yarns closer to parallel than this are taken to be this close: their angle's sine stays away from zero.
inline constexpr double largest_cos_2theta = 1 - 1e-12;

/// The trellis from the cosine of the angle between the yarns, d_f . d_w; no angle is needed.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Trellis<Real> trellis_of(const Real& cos_2theta) {
    const Real c2 = clamp(cos_2theta, Real(-largest_cos_2theta), Real(largest_cos_2theta));
    const Real c = sqrt(0.5 + 0.5 * c2);
    const Real s = sqrt(0.5 - 0.5 * c2);
    return {.cos_2theta = c2, .sin_2theta = 2.0 * c * s, .cos_theta = c, .sin_theta = s};
}

/// phi = theta - 45 deg, rad: sin 2 phi = -cos 2 theta, hence tan phi = -cos 2 theta/(1 + sin 2 theta).
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Real angle_from_45(const Trellis<Real>& trellis) {
    return atan(Real(-trellis.cos_2theta / (1.0 + trellis.sin_2theta)));
}

/// Symmetric tensor in the plane.
template <class Real>
struct PlaneTensor {
    Real xx, yy, xy;  ///< 1 (a strain), Pa (a stress) or N/m (resultants)
};

/// Strain increment in the bisector frame, dE = sym((G^{n+1} - G^n) ((G^n + G^{n+1})/2)^-1), IT04 (8), of the
/// yarn vectors G = [g_f g_w] with g_f = lambda_f (cos theta, sin theta), g_w = lambda_w (cos theta, -sin
/// theta). xy is the tensor component.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE PlaneTensor<Real> strain_increment(
    const Real& lambda_f0, const Real& lambda_w0, const Trellis<Real>& from, const Real& lambda_f1,
    const Real& lambda_w1, const Trellis<Real>& to) {
    const Real fx0 = lambda_f0 * from.cos_theta, fy0 = lambda_f0 * from.sin_theta;
    const Real wx0 = lambda_w0 * from.cos_theta, wy0 = -lambda_w0 * from.sin_theta;
    const Real fx1 = lambda_f1 * to.cos_theta, fy1 = lambda_f1 * to.sin_theta;
    const Real wx1 = lambda_w1 * to.cos_theta, wy1 = -lambda_w1 * to.sin_theta;
    const Real fx = 0.5 * (fx0 + fx1), fy = 0.5 * (fy0 + fy1);
    const Real wx = 0.5 * (wx0 + wx1), wy = 0.5 * (wy0 + wy1);
    const Real dfx = fx1 - fx0, dfy = fy1 - fy0;
    const Real dwx = wx1 - wx0, dwy = wy1 - wy0;
    const Real inverse = 1.0 / (fx * wy - fy * wx);
    const Real xx = (dfx * wy - dwx * fy) * inverse;
    const Real xy = (dwx * fx - dfx * wx) * inverse;
    const Real yx = (dfy * wy - dwy * fy) * inverse;
    const Real yy = (dwy * fx - dfy * wx) * inverse;
    return {xx, yy, 0.5 * (xy + yx)};
}

/// Lateral strain and engineering shear in a yarn's own axes, IT04 (9).
template <class Real>
struct LateralStrain {
    Real eps_22, gamma_12;  ///< 1
};

/// `strain` rotated by +theta (fill, `sine` = sin theta) or -theta (warp, `sine` = -sin theta).
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE LateralStrain<Real> lateral_strain(const PlaneTensor<Real>& strain,
                                                                   const Real& cosine, const Real& sine) {
    const Real sc = sine * cosine;
    return {sine * sine * strain.xx + cosine * cosine * strain.yy - 2.0 * sc * strain.xy,
            2.0 * sc * (strain.yy - strain.xx) + 2.0 * (cosine * cosine - sine * sine) * strain.xy};
}

/// A yarn's stress 11, 22, 12 rotated back to the bisector frame, IT04 (42); `sine` as in lateral_strain.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE PlaneTensor<Real> to_bisector_frame(const Real& s11, const Real& s22,
                                                                    const Real& s12, const Real& cosine,
                                                                    const Real& sine) {
    const Real cc = cosine * cosine, ss = sine * sine, sc = sine * cosine;
    return {cc * s11 + ss * s22 - 2.0 * sc * s12, ss * s11 + cc * s22 + 2.0 * sc * s12,
            sc * (s11 - s22) + (cc - ss) * s12};
}

/// Forces per reference area conjugate to ln lambda_f, ln lambda_w and theta: the power is fill dln lambda_f
/// + warp dln lambda_w + angle dtheta.
template <class Real>
struct Forces {
    Real fill = 0.0, warp = 0.0, angle = 0.0;  ///< N/m; angle per rad
};

/// Kirchhoff resultants in the bisector frame: n_f d_f d_f + n_w d_w d_w + m sin theta cos theta (y y - x x).
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE PlaneTensor<Real> resultants(const Forces<Real>& n,
                                                             const Trellis<Real>& trellis) {
    const Real sc = 0.5 * trellis.sin_2theta;
    const Real sum = n.fill + n.warp;
    return {sum * (trellis.cos_theta * trellis.cos_theta) - n.angle * sc,
            sum * (trellis.sin_theta * trellis.sin_theta) + n.angle * sc, (n.fill - n.warp) * sc};
}

/// The inverse of `resultants`.
template <class Real>
[[nodiscard]] WEAVEFRONT_INLINE Forces<Real> forces(const PlaneTensor<Real>& T,
                                                    const Trellis<Real>& trellis) {
    const Real mean = 0.5 * (T.xx + T.yy);
    const Real inverse = 1.0 / trellis.sin_2theta;
    const Real half_difference = T.xy * inverse;
    // tan = 2 sin^2/sin 2 theta, cot = 2 cos^2/sin 2 theta
    const Real angle =
        2.0 * inverse *
        (trellis.cos_theta * trellis.cos_theta * T.yy - trellis.sin_theta * trellis.sin_theta * T.xx);
    return {mean + half_difference, mean - half_difference, angle};
}

}  // namespace weavefront::fabric
