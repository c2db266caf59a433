#pragma once
/// @file
/// Characters of UTF-8.

#include <cstddef>
#include <string_view>

namespace weavefront::scene {

/// One character of a text; `bytes` 0: what begins there is not UTF-8.
struct Character {
    char32_t code = 0;
    std::size_t bytes = 0;
};

/// The character at the start of a text that is not empty. Overlong forms, surrogates and codes beyond
/// U+10FFFF are not UTF-8.
Character first_character(std::string_view text);

/// Number of characters.
int characters_in(std::string_view text);

/// Spaces of Unicode with a width, other than the usual one: no-break, en, em, thin, figure, ideographic, ...
bool is_other_space(char32_t code);

/// Characters that leave no mark: controls, spaces other than the usual one, those of no width, byte order
/// marks.
bool is_invisible(char32_t code);

}  // namespace weavefront::scene
