#pragma once
/// @file
/// Bound on the highest frequency of an element.

#include <algorithm>
#include <cmath>

#include "weavefront/fabric/stiffness.hpp"
#include "weavefront/shell/hourglass.hpp"
#include "weavefront/shell/quad.hpp"

namespace weavefront::shell {

/// Largest eigenvalue of M G for symmetric positive 2x2 matrices given as {11, 12, 22}.
inline double largest_eigenvalue(const std::array<double, 3>& M, const std::array<double, 3>& G) {
    const double trace = M[0] * G[0] + 2 * M[1] * G[1] + M[2] * G[2];
    const double determinant = (M[0] * M[2] - M[1] * M[1]) * (G[0] * G[2] - G[1] * G[1]);
    return trace / 2 + std::sqrt(std::max(trace * trace / 4 - determinant, 0.0));
}

/// Bound on omega^2 of an element with a quarter of its mass on each node; by the element eigenvalue inequality its maximum over the
/// elements bounds the whole model.
///
/// The membrane's quadratic form is at most sum M_ij |dg_i| |dg_j| over the yarn vectors with M from the tangent bounds k of the cell:
/// M_ff = k_f + k_lateral + k_angle/lambda_f^2, M_fw = k_angle/(lambda_f lambda_w), because |d(2 theta)| <= |dg_f|/lambda_f +
/// |dg_w|/lambda_w.
/// With dg = B du and G = B B^T the frequency is 4 lambda_max(M G)/areal density. Hourglass modes are orthogonal to B in a parallelogram
/// (the larger counts); otherwise the two are added.
template <class State>
double critical_frequency_squared(const Quad<double>& quad, const fabric::Stiffness<double>& k, const State& state,
                                  const HourglassStiffness& hourglass, double areal_density) {
    const double f = 1 / state.lambda_f, w = 1 / state.lambda_w;
    const std::array<double, 3> M{k.yarn_f + k.lateral + k.angle * f * f, k.angle * f * w, k.yarn_w + k.lateral + k.angle * w * w};
    const std::array<double, 3> G{2 * (quad.Bf1 * quad.Bf1 + quad.Bf2 * quad.Bf2), 2 * std::abs(quad.Bf1 * quad.Bw1 + quad.Bf2 * quad.Bw2),
                                  2 * (quad.Bw1 * quad.Bw1 + quad.Bw2 * quad.Bw2)};
    const double membrane = 4 * largest_eigenvalue(M, G) / areal_density;
    const double gamma_squared = (2 + quad.e1 * quad.e1 + quad.e2 * quad.e2) / 8;
    const double modes = 4 * std::max(hourglass.in_plane, hourglass.warping) * quad.shape * gamma_squared / (areal_density * quad.area);
    const bool parallelogram = quad.e1 == 0 && quad.e2 == 0;
    return parallelogram ? std::max(membrane, modes) : membrane + modes;
}

}  // namespace weavefront::shell
