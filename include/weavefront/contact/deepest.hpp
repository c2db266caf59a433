#pragma once
/// @file
/// The deepest penetration of a step.

#include <cstdint>

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// The contact point whose overlap is the largest part of the thickness at which its sides touch. It counts
/// whether it presses or not.
struct Deepest {
    double overlap = 0;         ///< m
    double in_thicknesses = 0;  ///< the same over the contact thickness
    Vec3 place{0, 0, 0};        ///< of the point, m
    std::int64_t element = -1;  ///< global, of the point; -1: nothing is in contact
    double time = 0;            ///< s

    /// Keeps the deeper one; of two alike the one of the lower element, so that the order does not matter.
    /// @return whether it is the other
    bool include(const Deepest& other) {
        const bool deeper = other.in_thicknesses > in_thicknesses;
        if (!deeper &&
            !(other.in_thicknesses == in_thicknesses && other.element >= 0 && other.element < element))
            return false;
        *this = other;
        return true;
    }
};

}  // namespace weavefront::contact
