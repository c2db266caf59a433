#pragma once
/// @file
/// Small files written at once.

#include <filesystem>
#include <string>

namespace weavefront::io {

/// Makes sure, before the work that the text takes, that `replace_file` may write there. @throws FileError
void require_replaceable(const std::filesystem::path& path);

/// Writes a file as a whole or not at all: under a temporary name first, then renamed. @throws FileError
void replace_file(const std::filesystem::path& path, const std::string& text);

}  // namespace weavefront::io
