#pragma once
/// @file
/// Shots of a range, read from CSV.

#include <string>
#include <vector>

#include "weavefront/ballistics/shot.hpp"

namespace weavefront::app {

/// A shot and where it stands.
struct RangeShot {
    ballistics::Shot shot;
    std::string where;  ///< file:line
};

/// Reads shots: a header with `result` and one of `speed_m_s`, `speed_ft_s` and `speed` (whose cells have
/// their unit), then rows. Rows without a result, as v50.csv has them, are left out.
/// @param name of the file, for messages
/// @throws scene::InputError with every finding as `name:line:column: COLUMN: found ..., allowed ...`
std::vector<RangeShot> parse_range_shots(const std::string& text, const std::string& name);

}  // namespace weavefront::app
