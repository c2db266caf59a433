#pragma once
/// @file
/// Eight contact points of one facet at once. Loops over lanes are left to the compiler to vectorise; the
/// lanes of a batch are always the same points of the same facet, so what a lane yields may depend on the
/// others and is still the same on every rank.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

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

}  // namespace weavefront::contact
