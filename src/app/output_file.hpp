#pragma once
/// @file
/// The file that a command is to write.

#include <filesystem>
#include <initializer_list>

namespace weavefront::app {

/// Makes sure that a file that is to be written is none of those that the command reads.
/// @param option the one that names it, such as --out
/// @throws scene::InputError
void require_other_file(const char* option, const std::filesystem::path& file,
                        std::initializer_list<std::filesystem::path> read);

/// The same, and that it can be written, before anything is computed. @throws scene::InputError,
/// io::FileError
void require_output_file(const char* option, const std::filesystem::path& file,
                         std::initializer_list<std::filesystem::path> read);

}  // namespace weavefront::app
