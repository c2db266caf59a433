#pragma once
/// @file
/// A 3-vector over a scalar or a pack.

#include "weavefront/simd/real.hpp"

namespace weavefront::shell {

template <class Real>
struct Vector {
    Real x, y, z;

    WEAVEFRONT_INLINE friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    WEAVEFRONT_INLINE friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    WEAVEFRONT_INLINE friend Vector operator*(const Real& s, const Vector& a) {
        return {s * a.x, s * a.y, s * a.z};
    }
};

template <class Real>
WEAVEFRONT_INLINE Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
WEAVEFRONT_INLINE Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace weavefront::shell
