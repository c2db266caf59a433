#pragma once
/// @file
/// Values given on the command line in place of those of the file.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "document.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/study.hpp"

namespace weavefront::scene {

/// Puts each override into the tree, creating the maps on its way; the reader then judges it as if it stood
/// in the file.
/// @param root      tree of the scene
/// @param overrides `PATH=VALUE`; PATH has dots between keys and numbers from 0 for list items, VALUE is
/// YAML, empty: leave the key out
/// @param findings  receives overrides that lead nowhere
void apply_overrides(Value& root, const std::vector<std::string>& overrides, Findings& findings);

/// The same for the settings of a study, whose findings point into its file.
void apply_settings(Value& root, std::span<const Setting> settings, Findings& findings);

/// What is done to the tree of a scene before it is read.
using Change = std::function<void(Value&, Findings&)>;

/// `parse_scene` with any change of its tree.
Scene parse_changed_scene(const std::string& text, const std::string& name, const Change& change, Need need,
                          const ReadFile& read_file = {});

}  // namespace weavefront::scene
