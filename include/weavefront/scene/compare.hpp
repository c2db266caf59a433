#pragma once
/// @file
/// What differs between two scenes.

#include <string>
#include <string_view>
#include <vector>

namespace weavefront::scene {

/// A key that two scenes give different values.
struct Difference {
    std::string path;           ///< `target.mesh.center`
    std::string first, second;  ///< values; empty: the scene has none
};

/// All keys in which two scenes differ. @param first, second as Scene::resolved
std::vector<Difference> differences(const std::string& first, const std::string& second);

}  // namespace weavefront::scene
