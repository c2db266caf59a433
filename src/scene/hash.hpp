#pragma once
/// @file
/// Names for contents.

#include <string>
#include <string_view>

namespace weavefront::scene {

/// 16 hex digits, FNV-1a of 64 bits.
std::string hash_of(std::string_view text);

}  // namespace weavefront::scene
