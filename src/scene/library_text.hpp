#pragma once
/// @file
/// The files fabrics.yaml and projectiles.yaml, which the build puts into the program.

#include <string>

namespace weavefront::scene {

std::string fabrics_text();
std::string projectiles_text();

}  // namespace weavefront::scene
