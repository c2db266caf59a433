#pragma once
/// @file
/// The deepest penetration of a step.

#include <cstdint>

#include "weavefront/mesh/vec3.hpp"

namespace weavefront::contact {

/// The contact point with the largest overlap over its contact distance, whether it presses or not.
struct Deepest {
    double overlap = 0;         ///< m
    double in_thicknesses = 0;  ///< overlap over the contact distance
    Vec3 place{0, 0, 0};        ///< of the point, m
    std::int64_t element = -1;  ///< global id of the point's element; -1: no contact
    double time = 0;            ///< s

    /// Keeps the deeper of two points. At equal depth the lower element id decides, so the order does not
    /// matter.
    /// @return whether `other` replaced this one
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
