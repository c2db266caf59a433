#pragma once
/// @file
/// From results.vtkhdf to the middle line of a strip.

#include <filesystem>
#include <vector>

#include "weavefront/study/strip.hpp"

namespace weavefront::app {

/// The line y = 0 over the frames; the strain of the fill is its mean across the strip.
/// @throws io::FileError when the file cannot be read or holds no strain
std::vector<study::StripFrame> strip_frames(const std::filesystem::path& results);

}  // namespace weavefront::app
