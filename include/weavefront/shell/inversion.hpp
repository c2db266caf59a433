#pragma once
/// @file
/// Quads that have turned over.

#include <array>

#include "weavefront/shell/vector.hpp"
#include "weavefront/simd/real.hpp"

namespace weavefront::shell {

/// True where the quad is folded over itself: |g_f x g_w| is never negative, but of the four corner normals
/// (the orientation of the quad at its corners) two or more then point against the mean normal, or all are at
/// odds with it.
/// @param x current corners, m
template <class Real>
WEAVEFRONT_INLINE simd::MaskOf<Real> is_inverted(const std::array<Vector<Real>, 4>& x) {
    using simd::select;
    const auto mean = cross(x[2] - x[0], x[3] - x[1]);
    Real against = 0.0;
    for (std::size_t a = 0; a < 4; ++a) {
        const auto normal = cross(x[(a + 1) % 4] - x[a], x[(a + 3) % 4] - x[a]);
        against +=
            select(normal.x * mean.x + (normal.y * mean.y + normal.z * mean.z) <= 0.0, Real(1.0), Real(0.0));
    }
    return against >= 2.0;
}

}  // namespace weavefront::shell
