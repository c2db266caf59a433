#pragma once
/// @file
/// The parts of a study file that give values to keys of a scene.

#include <string>
#include <vector>

#include "section.hpp"
#include "weavefront/scene/study.hpp"

namespace weavefront::scene {

/// A value as YAML in flow style, which parses to the same value again.
std::string flow_text(const Value& value);

/// A map of paths and values. @param path of the map in the study file
std::vector<Setting> read_settings(const Value& map, const std::string& path, Context& context);

/// `variants`: a list of maps of one key each. Below it is a list of values of that path, or a map of named
/// settings.
std::vector<Axis> read_axes(const Value& list, Context& context);

}  // namespace weavefront::scene
