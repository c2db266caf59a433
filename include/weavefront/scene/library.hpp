#pragma once
/// @file
/// The library of fabrics that come with the program.

#include <optional>
#include <string>
#include <vector>

namespace weavefront::scene {

/// One value of a fabric.
struct LibraryValue {
    std::string key;                   ///< below the fabric, with dots: `yarn.denier`
    std::string text;                  ///< as a scene file states it: `34 1/in`
    std::string source;                ///< in words
    std::optional<double> confidence;  ///< that the source says so, where it was quoted from memory, 0 to 1
};

struct LibraryFabric {
    std::string name, title;
    std::vector<LibraryValue> values;
};

/// All fabrics, in the order of the library.
const std::vector<LibraryFabric>& fabric_library();

}  // namespace weavefront::scene
