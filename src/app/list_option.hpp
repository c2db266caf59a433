#pragma once
/// @file
/// Lists on the command line.

#include <string>
#include <string_view>
#include <vector>

namespace weavefront::app {

/// The items of a list with commas between them. Empty ones are items, too: `1,,2` has three, an empty text
/// one.
inline std::vector<std::string> items_of(std::string_view list) {
    std::vector<std::string> items(1);
    for (const char c : list)
        if (c == ',')
            items.emplace_back();
        else
            items.back() += c;
    return items;
}

}  // namespace weavefront::app
