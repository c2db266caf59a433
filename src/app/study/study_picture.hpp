#pragma once
/// @file
/// The work-precision picture.

#include <filesystem>

namespace weavefront::app {

/// Has weavefront-plot, which is installed or built beside this program, draw study.png; says how to draw it
/// where that cannot be. On the first rank only, after MPI is done with.
void draw_study(const std::filesystem::path& folder);

}  // namespace weavefront::app
