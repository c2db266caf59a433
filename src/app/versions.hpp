#pragma once
/// @file
/// What the program was built from.

#include <map>
#include <string>

namespace weavefront::app {

/// Versions of Weavefront and of the libraries whose results it depends on.
std::map<std::string, std::string> library_versions();

}  // namespace weavefront::app
