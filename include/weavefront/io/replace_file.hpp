#pragma once
/// @file
/// Small files written at once.

#include <filesystem>
#include <string>

namespace weavefront::io {

/// Writes a file as a whole or not at all: under a temporary name first, then renamed. @throws FileError
void replace_file(const std::filesystem::path& path, const std::string& text);

}  // namespace weavefront::io
