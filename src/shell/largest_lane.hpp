#pragma once
/// @file
/// The largest of eight lanes.

#include <algorithm>

#include "weavefront/fabric/pack.hpp"

namespace weavefront::shell {

[[nodiscard]] inline double largest_lane(const fabric::Pack& values) {
    double largest = values.get(0);
    for (int lane = 1; lane < fabric::pack_width; ++lane) largest = std::max(largest, values.get(lane));
    return largest;
}

}  // namespace weavefront::shell
