#pragma once
/// @file
/// Values of a scene that are taken from a library.

#include <span>
#include <string_view>

#include "document.hpp"
#include "findings.hpp"
#include "weavefront/scene/library.hpp"

namespace weavefront::scene {

/// A key of the scene, and a key of the library that it leaves without a meaning.
struct Replaced {
    std::string_view scene, library;
};

/// Replaces a key of a map by the values of the library's entry that it names. Values of the scene come
/// before those of the library.
/// @param path of the map, for messages
/// @throws InputError where the library has no such entry
void insert_from_library(Value& map, std::string_view key, std::string_view path, const Library& library,
                         std::span<const Replaced> replaced, Findings& findings);

}  // namespace weavefront::scene
