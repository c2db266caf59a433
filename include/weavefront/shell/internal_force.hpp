#pragma once
/// @file
/// One step of one element (or of a pack of them): strain, stress, nodal forces.

#include <limits>

#include "weavefront/fabric/cell.hpp"
#include "weavefront/shell/hourglass.hpp"
#include "weavefront/shell/quad.hpp"

namespace weavefront::shell {

template <class Real>
struct ElementForces {
    std::array<Vector<Real>, 3>
        corner;             ///< on the nodes of corners 1 to 3, N; corner 4 takes minus their sum
    Real hourglass_energy;  ///< J
};

/// Advances the fabric state to the current positions and returns the nodal forces
/// f_a = -A_0 (P_f B_fa + P_w B_wa) - gamma_a dPhi/dq, where P = T g^ is the resultant T = t_e tau
/// (Kirchhoff, in the bisector frame) times the dual of the yarn vector. With T of the consistent formulation
/// they are exactly the derivatives of the work n_f dln lambda_f + n_w dln lambda_w + m dtheta.
/// @param x current corners, m
template <fabric::Features F, class Real>
WEAVEFRONT_INLINE ElementForces<Real> internal_force(
    const fabric::Constants& constants, const fabric::Step& step, const HourglassStiffness& hourglass,
    const Quad<Real>& quad, const std::array<Vector<Real>, 4>& x, fabric::State<Real>& state) {
    using simd::max;
    using simd::sqrt;
    const Real tiny = Real(std::numeric_limits<double>::min());
    const auto k = kinematics_of(quad, x);
    const Real lambda_f = sqrt(max(dot(k.g_f, k.g_f), tiny)), lambda_w = sqrt(max(dot(k.g_w, k.g_w), tiny));
    const auto d_f = (Real(1.0) / lambda_f) * k.g_f, d_w = (Real(1.0) / lambda_w) * k.g_w;
    const auto response = fabric::advance<F>(constants, step, state, lambda_f, lambda_w, dot(d_f, d_w));

    // Dual vectors in the bisector frame: g^f = (s, c)/(lambda_f sin 2theta), g^w = (s, -c)/(lambda_w sin
    // 2theta); x, y = (d_f +- d_w)/(2c, 2s).
    const Real s = response.sin_theta, c = response.cos_theta, half = Real(0.5),
               sin_2theta = Real(2.0) * s * c;
    const Real xx = response.T_xx * s, yy = response.T_yy * c, xs = response.T_xy * s, xc = response.T_xy * c;
    const Real along_c = half / c, along_s = half / s;
    const auto resultant = [&](const Real& a, const Real& b, const Real& lambda)
        __attribute__((always_inline)) {
        const Real scale = quad.area / (lambda * sin_2theta);
        return (scale * (a * along_c + b * along_s)) * d_f + (scale * (a * along_c - b * along_s)) * d_w;
    };
    auto P_f = resultant(xx + xc, xs + yy, lambda_f), P_w = resultant(xx - xc, xs - yy, lambda_w);

    // The modes stand for yarns of both directions held by each other: a cell with a broken yarn no longer
    // resists them.
    auto resisting = quad;
    if constexpr (F.failure) resisting.shape = quad.shape * (state.intact_f * state.intact_w);
    const auto normal = cross(k.g_f, k.g_w);
    const auto hg = hourglass_force(hourglass, resisting, k, normal, sqrt(max(dot(normal, normal), tiny)));
    P_f = P_f + hg.P_f;
    P_w = P_w + hg.P_w;

    const auto f1 = quad.Bf1 * P_f + quad.Bw1 * P_w, f2 = quad.Bf2 * P_f + quad.Bw2 * P_w;
    const Real minus_one = Real(-1.0), quarter = Real(0.25);
    const auto h = quarter * hg.force, h1 = quad.e1 * h, h2 = quad.e2 * h;
    return {{minus_one * (f1 + (h - h1)), h + h2 - f2, f1 - (h + h1)}, hg.energy};
}

}  // namespace weavefront::shell
