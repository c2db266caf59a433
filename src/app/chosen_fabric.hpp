#pragma once
/// @file
/// The fabric that a command works on.

#include <filesystem>
#include <string>
#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// Reads the fabrics of a scene and picks one.
/// @param path scene file
/// @param overrides of its values, as of --set
/// @param name of the fabric; empty: the scene's only one
/// @throws scene::InputError for a scene at fault, a name that it lacks, or no name where it has several
[[nodiscard]] scene::Fabric chosen_fabric(const std::filesystem::path& path,
                                          const std::vector<std::string>& overrides, const std::string& name);

}  // namespace weavefront::app
