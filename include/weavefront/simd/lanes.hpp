#pragma once
/// @file
/// Eight numbers for loops over their lanes, which the compiler vectorises. Contact computes its batches of
/// eight points of one facet so: their lanes are the same points on every rank, so results may depend on all
/// lanes.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace weavefront::simd {

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

}  // namespace weavefront::simd
