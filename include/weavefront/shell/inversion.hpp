#pragma once
/// @file
/// Quads that have turned over.

#include <Eigen/Geometry>
#include <array>

namespace weavefront::shell {

/// True when the quad is folded over itself: |g_f x g_w| is never negative, but of the four corner normals (the orientation of the quad
/// at its corners) two or more then point against the mean normal, or all are at odds with it.
/// @param x current corners, m
inline bool is_inverted(const std::array<Eigen::Vector3d, 4>& x) {
    const Eigen::Vector3d mean = (x[2] - x[0]).cross(x[3] - x[1]);
    int against = 0;
    for (std::size_t a = 0; a < 4; ++a) {
        const Eigen::Vector3d next = x[(a + 1) % 4] - x[a], last = x[(a + 3) % 4] - x[a];
        if (next.cross(last).dot(mean) <= 0) ++against;
    }
    return against >= 2;
}

}  // namespace weavefront::shell
