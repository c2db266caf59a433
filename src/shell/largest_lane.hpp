#pragma once
/// @file
/// The largest of eight lanes.

#include <algorithm>

#include "weavefront/simd/pack.hpp"

namespace weavefront::shell {

[[nodiscard]] inline double largest_lane(const simd::Pack& values) {
    double largest = values.get(0);
    for (int lane = 1; lane < simd::pack_width; ++lane) largest = std::max(largest, values.get(lane));
    return largest;
}

}  // namespace weavefront::shell
