#pragma once
/// @file
/// The central-difference scheme: velocities in the middle of the steps, positions and forces at their ends.
///
///     v(n+1/2) = v(n-1/2) + (dt(n-1) + dt(n))/2 a(n)
///     v(n)     = v(n-1/2) + dt(n-1)/2 a(n)
///     x(n+1)   = x(n) + dt(n) v(n+1/2)
///
/// A vector is a component, a Vec3 or a pack of components.

namespace weavefront::solver {

/// v(n+1/2). @param step (dt(n-1) + dt(n))/2, s
template <class Vector>
[[nodiscard, gnu::always_inline]] inline Vector next_velocity(const Vector& v, const Vector& acceleration,
                                                              double step) {
    return v + step * acceleration;
}

/// The same with damping proportional to mass, taken half before and half after a(n). @param drag rate times
/// step/2, 1
template <class Vector>
[[nodiscard, gnu::always_inline]] inline Vector next_velocity(const Vector& v, const Vector& acceleration,
                                                              double step, double drag) {
    return ((1 - drag) * v + step * acceleration) / (1 + drag);
}

/// a(n), damping included, by which the velocity changes over a step.
template <class Vector>
[[nodiscard, gnu::always_inline]] inline Vector acceleration_between(const Vector& v, const Vector& next,
                                                                     double step) {
    return (next - v) / step;
}

/// v(n). @param last_dt dt(n-1), s
template <class Vector>
[[nodiscard, gnu::always_inline]] inline Vector present_velocity(const Vector& v, const Vector& acceleration,
                                                                 double last_dt) {
    return v + last_dt / 2 * acceleration;
}

/// v(n-1/2) + dt(n-1) a(n): m v(n-1/2) times it over 2 is the kinetic energy with which the ledger closes.
template <class Vector>
[[nodiscard, gnu::always_inline]] inline Vector opposite_velocity(const Vector& v, const Vector& acceleration,
                                                                  double last_dt) {
    return v + last_dt * acceleration;
}

}  // namespace weavefront::solver
