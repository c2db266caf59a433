#pragma once
/// @file
/// Hourglass control and warping: the modes that one quadrature point does not see.

#include "weavefront/shell/quad.hpp"
#include "weavefront/simd/math.hpp"

namespace weavefront::shell {

/// Stiffness of the hourglass modes per unit of Quad::shape.
///
/// A displacement q (xi eta) has the membrane energy C t_e q^2/2 int (d(xi eta)/dx)^2 and, out of the plane,
/// the transverse shear energy G23 t_e q^2/2 int |grad(xi eta)|^2: the normals stay with the mean plane, so
/// warping is all the transverse shear there is. Warping takes this in full (closed form), the in-plane modes
/// a fraction `hourglass` of it with C t_e = E1 S/s. Warping is never resisted less than they are: without
/// transverse shear it is an hourglass mode like the others.
struct HourglassStiffness {
    double in_plane = 0;  ///< N/m
    double warping = 0;   ///< N/m, >= in_plane
};

template <class Real>
struct HourglassForce {
    Vector<Real> force;     ///< conjugate to q, N
    Vector<Real> P_f, P_w;  ///< conjugate to g_f and g_w (the normal turns with them), N m
    Real energy;            ///< J
};

/// Forces of the potential Phi = k_i |q|^2/2 + (k_w - k_i) |m| (q . n)^2/2 with m = g_f x g_w and n = m/|m|.
/// All derivatives are taken, so the two stiffnesses may differ without making or losing energy; the factor
/// |m|, the present over the initial area, keeps them finite where an element collapses to a line and n is
/// not defined.
/// @param m      g_f x g_w
/// @param length |m|, > 0
template <class Real>
WEAVEFRONT_INLINE HourglassForce<Real> hourglass_force(const HourglassStiffness& stiffness,
                                                       const Quad<Real>& quad, const Kinematics<Real>& k,
                                                       const Vector<Real>& m, const Real& length) {
    const Real k_i = Real(stiffness.in_plane) * quad.shape,
               excess = Real(stiffness.warping - stiffness.in_plane) * quad.shape;
    const auto n = (Real(1.0) / length) * m;
    const Real q_n = dot(k.q, n), pressed = excess * q_n;
    const auto turning = pressed * k.q - (Real(0.5) * pressed * q_n) * n;  // dPhi/dm
    return {k_i * k.q + (pressed * length) * n, cross(k.g_w, turning), cross(turning, k.g_f),
            Real(0.5) * (k_i * dot(k.q, k.q) + pressed * q_n * length)};
}

}  // namespace weavefront::shell
