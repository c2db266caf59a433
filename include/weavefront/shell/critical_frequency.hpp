#pragma once
/// @file
/// Bound on the highest frequency of an element.

#include <array>
#include <cmath>

#include "weavefront/fabric/stiffness.hpp"
#include "weavefront/shell/hourglass.hpp"
#include "weavefront/shell/quad.hpp"

namespace weavefront::shell {

/// Bounds on omega^2 of an element with a quarter of its mass on each node, 1/s2. By the element eigenvalue
/// inequality their maxima over the elements bound the whole model.
template <class Real>
struct Frequencies {
    Real in_plane = 0.0;      ///< of motion in the element's plane
    Real out_of_plane = 0.0;  ///< of motion out of it
    Real hourglass = 0.0;     ///< of the hourglass modes in the plane, which `in_plane` counts
};

/// The bound on uniform deformation and hourglass modes together: these are orthogonal in parallelograms.
template <class Real>
WEAVEFRONT_INLINE Real with_hourglass(const simd::MaskOf<Real>& parallelogram, const Real& uniform,
                                      const Real& modes) {
    using simd::max;
    using simd::select;
    return select(parallelogram, max(modes, uniform), Real(uniform + modes));
}

/// Rounds omega^2 up by at most 0.4 %. An element that is no worse than one before it then needs no further
/// computation, and the time step does not follow the rounding of the state.
inline double rounded_up(double omega_squared) {
    constexpr double steps = 512;
    int exponent = 0;
    const double fraction = std::frexp(omega_squared, &exponent);
    return std::ldexp(std::ceil(fraction * steps) / steps, exponent);
}

/// Largest eigenvalue of M G for symmetric 2x2 matrices given as {11, 12, 22}, G positive.
template <class Real>
WEAVEFRONT_INLINE Real largest_eigenvalue(const std::array<Real, 3>& M, const std::array<Real, 3>& G) {
    using simd::max;
    using simd::sqrt;
    const Real trace = M[0] * G[0] + 2.0 * M[1] * G[1] + M[2] * G[2];
    const Real determinant = (M[0] * M[2] - M[1] * M[1]) * (G[0] * G[2] - G[1] * G[1]);
    return trace * 0.5 + sqrt(max(Real(0.0), Real(trace * trace * 0.25 - determinant)));
}

/// B_f . B_f, B_f . B_w and B_w . B_w over the corners, 1/m2.
template <class Real>
WEAVEFRONT_INLINE std::array<Real, 3> gradient_products(const Quad<Real>& quad) {
    return {2.0 * (quad.Bf1 * quad.Bf1 + quad.Bf2 * quad.Bf2),
            2.0 * (quad.Bf1 * quad.Bw1 + quad.Bf2 * quad.Bw2),
            2.0 * (quad.Bw1 * quad.Bw1 + quad.Bw2 * quad.Bw2)};
}

/// From bounds k of the cell's tangent with crossovers held.
///
/// In the plane the second variation is at most sum M_ij |dg_i| |dg_j| over the yarn vectors, because
/// |d(2 theta)| <= |dg_f|/lambda_f + |dg_w|/lambda_w. Here M_ff = k_f + k_lateral + k_angle/lambda_f^2 and
/// M_fw = k_angle/(lambda_f lambda_w). With dg = B du and G = B B^T, omega^2 is 4 lambda_max(M G)/areal
/// density. Out of the plane k.normal takes the place of M.
template <class Real>
WEAVEFRONT_INLINE Frequencies<Real> critical_frequencies(const Quad<Real>& quad,
                                                         const fabric::Stiffness<Real>& k,
                                                         const fabric::State<Real>& state,
                                                         const HourglassStiffness& hourglass,
                                                         double areal_density) {
    const Real f = 1.0 / state.lambda_f, w = 1.0 / state.lambda_w;
    const double scale = 4 / areal_density;
    const auto G = gradient_products(quad);
    const std::array<Real, 3> sizes{G[0], abs(G[1]), G[2]};
    const std::array<Real, 3> M{k.yarn_f + k.lateral + k.angle * f * f, k.angle * f * w,
                                k.yarn_w + k.lateral + k.angle * w * w};
    const auto parallelogram = (quad.e1 == 0.0) & (quad.e2 == 0.0);
    const Real gamma_squared = (2.0 + quad.e1 * quad.e1 + quad.e2 * quad.e2) * 0.125,
               modes = scale * gamma_squared * quad.shape / quad.area;
    const Real in_plane = hourglass.in_plane * modes;
    return {with_hourglass(parallelogram, Real(scale * largest_eigenvalue(M, sizes)), in_plane),
            with_hourglass(parallelogram, Real(scale * largest_eigenvalue(k.normal, G)),
                           Real(hourglass.warping * modes)),
            in_plane};
}

}  // namespace weavefront::shell
