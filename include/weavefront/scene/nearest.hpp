#pragma once
/// @file
/// The name that a user may have meant.

#include <span>
#include <string>
#include <string_view>

namespace weavefront::scene {

/// The one of `names` with the least edit distance (insert, delete, substitute, swap neighbours) from `word`,
/// in any case.
/// @returns empty when none is near: more than a third of the longer name would have to change, and more than
/// one letter
std::string nearest(std::string_view word, std::span<const std::string> names);

}  // namespace weavefront::scene
