#pragma once
/// @file
/// Texts as cells of a CSV file.

#include <string>

namespace weavefront::app {

/// In quotes where it holds a comma, a quote or the end of a line.
inline std::string quoted_cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == text.npos) return text;
    std::string doubled;
    for (const char c : text) doubled.append(c == '"' ? 2 : 1, c);
    return '"' + doubled + '"';
}

}  // namespace weavefront::app
