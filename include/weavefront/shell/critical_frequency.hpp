#pragma once
/// @file
/// Bound on the highest frequency of an element.

#include <algorithm>
#include <cmath>

#include "weavefront/fabric/stiffness.hpp"
#include "weavefront/fabric/tangent.hpp"
#include "weavefront/shell/hourglass.hpp"
#include "weavefront/shell/quad.hpp"
#include "weavefront/shell/symmetric_eigenvalue.hpp"

namespace weavefront::shell {

/// Largest eigenvalue of M G for symmetric positive 2x2 matrices given as {11, 12, 22}.
template <class Real>
WEAVEFRONT_INLINE Real largest_eigenvalue(const std::array<Real, 3>& M, const std::array<Real, 3>& G) {
    using fabric::max;
    using fabric::sqrt;
    const Real trace = M[0] * G[0] + 2.0 * M[1] * G[1] + M[2] * G[2];
    const Real determinant = (M[0] * M[2] - M[1] * M[1]) * (G[0] * G[2] - G[1] * G[1]);
    return trace * 0.5 + sqrt(max(Real(0.0), Real(trace * trace * 0.25 - determinant)));
}

/// B_f . B_f, B_f . B_w and B_w . B_w over the corners, 1/m2.
template <class Real>
WEAVEFRONT_INLINE std::array<Real, 3> gradient_products(const Quad<Real>& quad) {
    return {2.0 * (quad.Bf1 * quad.Bf1 + quad.Bf2 * quad.Bf2), 2.0 * (quad.Bf1 * quad.Bw1 + quad.Bf2 * quad.Bw2),
            2.0 * (quad.Bw1 * quad.Bw1 + quad.Bw2 * quad.Bw2)};
}

/// The membrane's omega^2 and the hourglass modes', which are orthogonal to it in a parallelogram (the larger counts); otherwise the two
/// are added.
template <class Real>
WEAVEFRONT_INLINE Real with_hourglass(const Real& membrane, const Quad<Real>& quad, const HourglassStiffness& hourglass,
                                      double areal_density) {
    using fabric::max;
    using fabric::select;
    const Real gamma_squared = (2.0 + quad.e1 * quad.e1 + quad.e2 * quad.e2) * 0.125;
    const Real modes = 4 * max(hourglass.in_plane, hourglass.warping) * quad.shape * gamma_squared / (areal_density * quad.area);
    const auto parallelogram = (quad.e1 == 0.0) & (quad.e2 == 0.0);
    return select(parallelogram, max(modes, membrane), membrane + modes);
}

/// Bound on omega^2 of an element with a quarter of its mass on each node; by the element eigenvalue inequality its maximum over the
/// elements bounds the whole model.
///
/// The membrane's quadratic form is at most sum M_ij |dg_i| |dg_j| over the yarn vectors with M from the tangent bounds k of the cell:
/// M_ff = k_f + k_lateral + k_angle/lambda_f^2, M_fw = k_angle/(lambda_f lambda_w), because |d(2 theta)| <= |dg_f|/lambda_f +
/// |dg_w|/lambda_w.
/// With dg = B du and G = B B^T the frequency is 4 lambda_max(M G)/areal density.
template <class Real>
WEAVEFRONT_INLINE Real critical_frequency_squared(const Quad<Real>& quad, const fabric::Stiffness<Real>& k,
                                                  const fabric::State<Real>& state, const HourglassStiffness& hourglass,
                                                  double areal_density) {
    const Real f = 1.0 / state.lambda_f, w = 1.0 / state.lambda_w;
    const std::array<Real, 3> M{k.yarn_f + k.lateral + k.angle * f * f, k.angle * f * w, k.yarn_w + k.lateral + k.angle * w * w};
    auto G = gradient_products(quad);
    G[1] = abs(G[1]);
    return with_hourglass(Real(4.0 * largest_eigenvalue(M, G) / areal_density), quad, hourglass, areal_density);
}

/// The same from the exact largest eigenvalue of B^T T B with the tangent T of the cell: no more than the bound above wherever yarns are
/// packed or taut, at some ten times its cost.
inline double critical_frequency_squared(const Quad<double>& quad, const fabric::Tangent& t, const HourglassStiffness& hourglass,
                                         double areal_density) {
    // B B^T = L L^T in blocks of 2 x 2, where R turns the warp's axes into the fill's.
    const auto G = gradient_products(quad);
    const double l11 = std::sqrt(G[0]), l21 = G[1] / l11, l22 = std::sqrt(std::max(G[2] - l21 * l21, 0.0));
    const Matrix4 L{{{l11, 0, 0, 0}, {0, l11, 0, 0}, {l21 * t.cosine, l21 * t.sine, l22, 0}, {-l21 * t.sine, l21 * t.cosine, 0, l22}}};
    Matrix4 TL{}, LTL{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) TL[i][j] += t.plane[i][k] * L[k][j];
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) LTL[i][j] += L[k][i] * TL[k][j];
    const double largest = std::max(largest_eigenvalue(LTL), largest_eigenvalue(t.normal, G));
    return with_hourglass(4 * largest / areal_density, quad, hourglass, areal_density);
}

}  // namespace weavefront::shell
