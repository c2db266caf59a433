#pragma once
/// @file
/// Eight contact points of one facet at once. Loops over lanes are left to the compiler to vectorise; the
/// lanes of a batch are always the same points of the same facet, so what a lane yields may depend on the
/// others and is still the same on every rank.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

inline constexpr std::size_t batch_width = 8;

/// One number per point.
struct alignas(64) Lanes {
    double of[batch_width];

    double& operator[](std::size_t i) { return of[i]; }
    double operator[](std::size_t i) const { return of[i]; }
};

/// One yes or no per point.
using LaneMask = std::array<bool, batch_width>;

inline bool any(const LaneMask& mask) { return std::bit_cast<std::uint64_t>(mask) != 0; }

/// One vector per point.
struct VectorLanes {
    Lanes x, y, z;
};

/// Value of a facet's corners at one point of a batch: the bits of `interpolate`.
/// @param N shape functions, [corner]
inline Vec3 at_point(const std::array<Vec3, 4>& corners, const std::array<Lanes, 4>& N, std::size_t i) {
    return N[0][i] * corners[0] + N[1][i] * corners[1] + N[2][i] * corners[2] + N[3][i] * corners[3];
}

/// Values of a facet's corners at the points of a batch.
/// @param N shape functions, [corner]
inline VectorLanes interpolate(const std::array<Vec3, 4>& corners, const std::array<Lanes, 4>& N) {
    VectorLanes out;
    for (std::size_t i = 0; i < batch_width; ++i) {
        out.x[i] = N[0][i] * corners[0].x() + N[1][i] * corners[1].x() + N[2][i] * corners[2].x() +
                   N[3][i] * corners[3].x();
        out.y[i] = N[0][i] * corners[0].y() + N[1][i] * corners[1].y() + N[2][i] * corners[2].y() +
                   N[3][i] * corners[3].y();
        out.z[i] = N[0][i] * corners[0].z() + N[1][i] * corners[1].z() + N[2][i] * corners[2].z() +
                   N[3][i] * corners[3].z();
    }
    return out;
}

}  // namespace weavefront::contact
