#pragma once
/// @file
/// Small files written at once.

#include <filesystem>
#include <string_view>

namespace weavefront::io {

/// Makes sure, before the work that the text takes, that `replace_file` may write there. @throws FileError
void require_replaceable(const std::filesystem::path& path);

/// Writes a file as a whole or not at all: under a temporary name first, then renamed, in place of a regular
/// file or nothing.
/// @throws FileError
void replace_file(const std::filesystem::path& path, std::string_view text);

}  // namespace weavefront::io
