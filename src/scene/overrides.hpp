#pragma once
/// @file
/// Values given on the command line in place of those of the file.

#include <string>
#include <vector>

#include "document.hpp"

namespace weavefront::scene {

/// Puts each override into the tree, creating the maps on its way; the reader then judges it as if it stood in the file.
/// @param root      tree of the scene
/// @param overrides `PATH=VALUE`; PATH has dots between keys and numbers from 0 for list items, VALUE is YAML, empty: leave the key out
/// @param findings  receives overrides that lead nowhere
void apply_overrides(Value& root, const std::vector<std::string>& overrides, Findings& findings);

}  // namespace weavefront::scene
