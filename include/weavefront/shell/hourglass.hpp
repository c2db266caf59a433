#pragma once
/// @file
/// Hourglass control and warping: the modes that one quadrature point does not see.

#include "weavefront/fabric/math.hpp"
#include "weavefront/shell/quad.hpp"

namespace weavefront::shell {

/// Stiffness of the hourglass modes per unit of Quad::shape, N/m.
///
/// A displacement q (xi eta) has the membrane energy C t_e q^2/2 int (d(xi eta)/dx)^2 and, out of the plane, the transverse shear energy
/// G23 t_e q^2/2 int |grad(xi eta)|^2: the normals stay with the mean plane, so warping is all the transverse shear there is. Warping
/// takes this in full (closed form), the in-plane modes a fraction `hourglass` of it with C t_e = E1 S/s.
struct HourglassStiffness {
    double in_plane = 0;
    double warping = 0;
};

template <class Real>
struct HourglassForce {
    Vector<Real> force;     ///< conjugate to q, N
    Vector<Real> P_f, P_w;  ///< conjugate to g_f and g_w (the normal turns with them), N m
    Real energy;            ///< J
};

/// Forces of the potential Phi = k_i |q|^2/2 + (k_w - k_i) (q . n)^2/2, n the unit normal of g_f x g_w. All derivatives are taken, so
/// the two stiffnesses may differ without making or losing energy.
/// @param normal g_f x g_w
/// @param length |normal|, > 0
template <class Real>
HourglassForce<Real> hourglass_force(const HourglassStiffness& stiffness, const Quad<Real>& quad, const Kinematics<Real>& k,
                                     const Vector<Real>& normal, const Real& length) {
    const Real k_i = Real(stiffness.in_plane) * quad.shape, excess = Real(stiffness.warping - stiffness.in_plane) * quad.shape;
    const Real per_length = Real(1.0) / length;
    const auto n = per_length * normal;
    const Real q_n = dot(k.q, n);
    const auto q_t = k.q - q_n * n;
    const Real turning = excess * q_n * per_length;  // q . dn = q_t . d(g_f x g_w)/|g_f x g_w|
    return {k_i * k.q + (excess * q_n) * n, turning * cross(k.g_w, q_t), turning * cross(q_t, k.g_f),
            Real(0.5) * (k_i * dot(k.q, k.q) + excess * q_n * q_n)};
}

}  // namespace weavefront::shell
