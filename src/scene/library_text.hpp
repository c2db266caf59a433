#pragma once
/// @file
/// The file fabrics.yaml, which the build puts into the program.

#include <string>

namespace weavefront::scene {

std::string library_text();

}  // namespace weavefront::scene
