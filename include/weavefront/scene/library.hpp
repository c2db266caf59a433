#pragma once
/// @file
/// The libraries of fabrics and projectiles that come with the program.

#include <optional>
#include <string>
#include <vector>

namespace weavefront::scene {

/// One value of a library.
struct LibraryValue {
    std::string key;                   ///< below the fabric or the projectile, with dots: `yarn.denier`
    std::string text;                  ///< as a scene file states it: `34 1/in`
    std::string source;                ///< in words
    std::optional<double> confidence;  ///< that the source says so, where it was quoted from memory, 0 to 1
};

/// A fabric, or a projectile.
struct LibraryEntry {
    std::string name, title;
    std::vector<LibraryValue> values;
};

/// Entries in the order of a library.
using Library = std::vector<LibraryEntry>;

const Library& fabric_library();
const Library& projectile_library();

}  // namespace weavefront::scene
