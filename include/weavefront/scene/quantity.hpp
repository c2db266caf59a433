#pragma once
/// @file
/// Quantities of options, such as `10 min` or `1200 ft/s`.

#include <string>
#include <string_view>
#include <variant>

namespace weavefront::scene {

/// Reads a time with its unit. @return s, or the problem: what was found and what is allowed
std::variant<double, std::string> duration_of(std::string_view text);

/// A speed with the unit in which it was written.
struct WrittenSpeed {
    double si = 0;     ///< m/s
    std::string unit;  ///< empty: a bare 0
};

/// Reads a speed with its unit. @return the speed, or the problem: what was found and what is allowed
std::variant<WrittenSpeed, std::string> speed_of(std::string_view text);

}  // namespace weavefront::scene
