#pragma once
/// @file
/// What is wrong with a text that is not YAML, in words of a scene's author.

#include <string>
#include <string_view>

namespace weavefront::scene {

/// A fault and where it stands, line and column from 1.
struct YamlFault {
    std::string what;
    int line = 1, column = 1;
};

/// Looks for the cause of a parser's complaint: tabs and strange spaces on its line or the one before, or
/// else what its words mean.
/// @param said         by yaml-cpp
/// @param line, column of its complaint, from 1
YamlFault yaml_fault(std::string_view text, std::string_view said, int line, int column);

}  // namespace weavefront::scene
