#pragma once
/// @file
/// Durations of options, such as `10 min`.

#include <string>
#include <string_view>
#include <variant>

namespace weavefront::scene {

/// Reads a time with its unit. @return s, or what the text is instead and how a time is written
std::variant<double, std::string> duration_of(std::string_view text);

}  // namespace weavefront::scene
