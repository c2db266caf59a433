#pragma once
/// @file
/// The quadratic form of an element's plane: tighter than `critical_frequencies`, and dearer.

#include <array>
#include <cmath>

#include "weavefront/fabric/tangent.hpp"
#include "weavefront/shell/critical_frequency.hpp"
#include "weavefront/shell/symmetric_eigenvalue.hpp"

namespace weavefront::shell {

/// Second variation of uniform deformation in the plane; its largest eigenvalue is omega^2. Blocks of two
/// belong to the changes of the fill's and of the warp's vector, in the fill's axes.
template <class Real>
struct MembraneForm {
    Real ff11, ff12, ff22, fw11, fw12, fw21, fw22, ww11, ww12, ww22;  ///< 1/s2
    Real area;  ///< what a coupling c of 1 N/m takes from fw12 and gives to fw21, where the element lies in
                ///< the plane, 1/s2 per N/m
};

/// @param t            tangent of the cell
/// @param cosine, sine of the angle from fill to warp
/// @param G            gradient products, 1/m2
template <class Real>
WEAVEFRONT_INLINE MembraneForm<Real> membrane_form(const fabric::Tangent<Real>& t, const Real& cosine,
                                                   const Real& sine, const std::array<Real, 3>& G,
                                                   double areal_density) {
    using simd::max;
    using simd::sqrt;
    // the warp's axes turned into the fill's
    const Real fw11 = t[0][2] * cosine - t[0][3] * sine, fw12 = t[0][2] * sine + t[0][3] * cosine;
    const Real fw21 = t[1][2] * cosine - t[1][3] * sine, fw22 = t[1][2] * sine + t[1][3] * cosine;
    const Real cc = cosine * cosine, ss = sine * sine, sc = sine * cosine;
    const Real ww11 = cc * t[2][2] - 2.0 * sc * t[2][3] + ss * t[3][3],
               ww22 = ss * t[2][2] + 2.0 * sc * t[2][3] + cc * t[3][3];
    const Real ww12 = sc * (t[2][2] - t[3][3]) + (cc - ss) * t[2][3];
    // B B^T = L L^T by blocks; L^T T L
    const Real scale = 4.0 / areal_density;
    const Real ratio = G[1] / G[0], g0 = scale * G[0], g1 = scale * G[1], g11 = g1 * ratio;
    const Real square = max(Real(G[0] * G[2] - G[1] * G[1]), Real(0.0)), g2 = scale * (square / G[0]),
               area = scale * sqrt(square);
    return {g0 * t[0][0] + 2.0 * g1 * fw11 + g11 * ww11,
            g0 * t[0][1] + g1 * (fw12 + fw21) + g11 * ww12,
            g0 * t[1][1] + 2.0 * g1 * fw22 + g11 * ww22,
            area * (fw11 + ratio * ww11),
            area * (fw12 + ratio * ww12),
            area * (fw21 + ratio * ww12),
            area * (fw22 + ratio * ww22),
            g2 * ww11,
            g2 * ww12,
            g2 * ww22,
            area};
}

/// Whether an eigenvalue is above omega_squared, 1/s2, when c, N/m, is taken: omega_squared less the form is
/// not positive definite.
template <class Real>
WEAVEFRONT_INLINE simd::MaskOf<Real> exceeds(const MembraneForm<Real>& form, const Real& omega_squared,
                                             const Real& c) {
    const Real f11 = omega_squared - form.ff11, f22 = omega_squared - form.ff22, f12 = form.ff12;
    const Real b11 = form.fw11, b12 = form.fw12 - c * form.area, b21 = form.fw21 + c * form.area,
               b22 = form.fw22;
    const Real determinant = f11 * f22 - f12 * f12;
    // Schur's complement of the fill's block, times its determinant
    const Real c11 = f22 * b11 + f12 * b21, c12 = f22 * b12 + f12 * b22, c21 = f12 * b11 + f11 * b21,
               c22 = f12 * b12 + f11 * b22;
    const Real s11 = determinant * (omega_squared - form.ww11) - (b11 * c11 + b21 * c21);
    const Real s22 = determinant * (omega_squared - form.ww22) - (b12 * c12 + b22 * c22);
    const Real s12 = determinant * form.ww12 + (b11 * c12 + b21 * c22);
    return !((f11 > 0.0) & (determinant > 0.0) & (s11 > 0.0) & (s11 * s22 - s12 * s12 > 0.0));
}

/// Largest eigenvalue when c, N/m, is taken, 1/s2.
inline double largest_eigenvalue(const MembraneForm<double>& form, double c) {
    const double b12 = form.fw12 - c * form.area, b21 = form.fw21 + c * form.area;
    return largest_eigenvalue(Matrix4{{{form.ff11, form.ff12, form.fw11, b12},
                                       {form.ff12, form.ff22, b21, form.fw22},
                                       {form.fw11, b21, form.ww11, form.ww12},
                                       {b12, form.fw22, form.ww12, form.ww22}}});
}

}  // namespace weavefront::shell
