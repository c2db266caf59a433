#pragma once
/// @file
/// Pictures of what a command has computed.

#include <filesystem>
#include <string>

namespace weavefront::app {

/// Has weavefront-plot, which is installed or built beside this program, draw the pictures of a folder; says
/// how to draw them where that cannot be. On the first rank only, after MPI is done with.
/// @param option of weavefront-plot that takes the folder, such as --study
void draw_pictures(const std::string& option, const std::filesystem::path& folder);

}  // namespace weavefront::app
