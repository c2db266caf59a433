#pragma once
/// @file
/// Fabrics of a scene that are taken from the library.

#include "document.hpp"
#include "findings.hpp"

namespace weavefront::scene {

/// Replaces the key `library` of each fabric by the values of that fabric. Values of the scene come before
/// those of the library. A value that states the same in another way, as `yarn.span` and `count` do, takes
/// the place of the library's, too.
void insert_library_fabrics(Value& scene, Findings& findings);

}  // namespace weavefront::scene
