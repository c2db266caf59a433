#pragma once
/// @file
/// What contact adds to the frequency of the fabric.

#include "weavefront/scene/scene.hpp"

namespace weavefront::solver {

/// Contact over the mass that it moves: omega^2 of its springs, 1/s2, and the rate 2 xi omega of its dampers,
/// 1/s.
///
/// The stiffness of a point that sticks is k_t 1 + (k_n - k_t) n n^T: `tangential` in every direction, and
/// `stiffness` along the normal on top of it.
struct ContactModes {
    double stiffness = 0, damping = 0;
    double tangential = 0;  ///< of friction, clamps included, 1/s2
};

/// Contact closed everywhere and unloading, on the slope of u k. The highest mode of a free stack of n plies
/// has f = 4 cos^2(pi/(2 n)) springs over its mass per area: omega^2 = f u k/m and 2 xi omega = f c/m. A
/// light projectile adds its own mode, with its cross-section for the area. Of several projectiles, the two
/// largest values count: fabric is between two of them at most.
///
/// With friction, points may stick or slip. A point that slips has the stiffness k_n (n + mu t) n^T. It adds
/// at most the largest eigenvalue of its symmetric part to the real part of any eigenvalue. That is
/// k_n (1 + sqrt(1 + mu^2))/2, which stands for u k.
[[nodiscard]] ContactModes contact_modes(const scene::Scene& scene);

/// Bound on omega^2 of fabric and contact together, 1/s2, without dampers.
///
/// The fabric resists motion in its elements' planes, contact motion along its own direction. The bound is
/// the larger eigenvalue of the 2 x 2 matrix of motion in the plane and out of it. With contact along the
/// normal it is the larger of in_plane and out_of_plane + contact; with any angle it is at most their sum.
/// @param in_plane, out_of_plane of the fabric, with respect to its elements, 1/s2
/// @param contact       of contact, 1/s2
/// @param sine_squared  of the largest angle between a normal of an element and a direction of contact; 1:
/// any angle
[[nodiscard]] double joint_frequency_squared(double in_plane, double out_of_plane, double contact,
                                             double sine_squared);

/// The same bound with the dampers and the tangential stiffness, which acts in every direction. Central
/// differences whose dampers see the velocity of half a step before are stable up to dt = 2/omega with
/// omega^2 = omega_0^2 + omega 2 xi omega_0. So contact counts as stiffness + omega damping.
[[nodiscard]] double damped_frequency_squared(double in_plane, double out_of_plane,
                                              const ContactModes& contact, double sine_squared);

/// The part `in_plane` of a given bound, 1/s2: the inverse of joint_frequency_squared, without dampers; 0:
/// none.
[[nodiscard]] double in_plane_of_joint(double joint, double out_of_plane, double contact,
                                       double sine_squared);

}  // namespace weavefront::solver
