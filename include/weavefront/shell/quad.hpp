#pragma once
/// @file
/// Reference geometry of the four-node quadrilateral with one quadrature point.

#include <Eigen/Core>
#include <array>

#include "weavefront/shell/vector.hpp"

namespace weavefront::shell {

/// What the element kernel needs of the reference configuration. With the shape function gradients b_a at the
/// centre, B_f = b . q0_f and B_w = b . q0_w (q0: initial yarn directions). At the centre of a quad b_3 =
/// -b_1 and b_4 = -b_2, so two corners say it all.
///
/// Hourglass vector: gamma = (h - e_1 (1,0,-1,0) - e_2 (0,1,0,-1))/4 with h = (1,-1,1,-1); e_1 = e_2 = 0 for
/// parallelograms.
template <class Real>
struct Quad {
    Real Bf1, Bf2;  ///< fill gradients of corners 1 and 2, 1/m
    Real Bw1, Bw2;  ///< warp gradients, 1/m
    Real e1, e2;    ///< see above, 1
    Real area;      ///< A_0, m2; 0 for an eroded element
    Real shape;     ///< integral of |grad(xi eta)|^2 over the element, 1; 0 for an eroded element
};

/// Number of doubles in a Quad<double>.
inline constexpr int quad_size = 8;

/// Reference geometry of a flat quad.
/// @param corners counter-clockwise about +z, m
/// @param angle   of the fill yarns to the x axis, rad
/// @throws std::invalid_argument when the quad is not convex
Quad<double> make_quad(const std::array<Eigen::Vector3d, 4>& corners, double angle);

/// The yarn vectors g_f = F q0_f and g_w = F q0_w from the current corners, and what hourglass control works
/// on.
template <class Real>
struct Kinematics {
    Vector<Real> g_f, g_w;  ///< convected yarn vectors, 1
    Vector<Real> q;         ///< hourglass displacement sum gamma_a x_a, m
};

template <class Real>
WEAVEFRONT_INLINE Kinematics<Real> kinematics_of(const Quad<Real>& quad,
                                                 const std::array<Vector<Real>, 4>& x) {
    const auto d13 = x[0] - x[2], d24 = x[1] - x[3];
    const Real quarter = Real(0.25);
    return {quad.Bf1 * d13 + quad.Bf2 * d24, quad.Bw1 * d13 + quad.Bw2 * d24,
            quarter * ((x[0] - x[1]) + (x[2] - x[3]) - (quad.e1 * d13 + quad.e2 * d24))};
}

}  // namespace weavefront::shell
