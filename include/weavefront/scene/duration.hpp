#pragma once
/// @file
/// Durations of options, such as `10 min`.

#include <string>
#include <string_view>
#include <variant>

namespace weavefront::scene {

/// Reads a time with its unit. @return s, or the problem: what was found and what is allowed
std::variant<double, std::string> duration_of(std::string_view text);

}  // namespace weavefront::scene
