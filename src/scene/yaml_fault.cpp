#include "yaml_fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "utf8.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> meanings{
    {{"end of map not found",
      "this line is indented unlike the keys above it, or a value above it is not complete"},
     {"end of sequence not found", "this line is indented unlike the '-' of the list above it"},
     {"end of map flow not found", "a '{' is not closed by '}', or a ',' is missing"},
     {"end of sequence flow not found", "a '[' is not closed by ']', or a ',' is missing"},
     {"illegal flow end", "a ']' or '}' closes what was not opened"},
     {"illegal map value", "a ':' stands where no value can begin; text that contains ': ' goes in quotes"},
     {"illegal map key", "a key stands where none can begin"},
     {"illegal block entry", "a '-' stands where no list item can begin"},
     {"illegal EOF in scalar", "a text in quotes is not closed"},
     {"illegal character in scalar", "a character that text without quotes cannot contain"},
     {"unknown token", "a character that no text without quotes begins with"},
     {"the referenced anchor is not defined", "an alias (*name) without an anchor (&name) before it"},
     {"invalid unicode", "an escape of no character of Unicode"},
     {"bad character found while scanning hex number", "an escape whose digits are not hexadecimal"}}};

std::string_view line_of(std::string_view text, int line) {
    for (; line > 1 && !text.empty(); --line)
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

/// A tab in the indentation of a line, or a space that YAML takes for a letter.
std::optional<YamlFault> blank_fault(std::string_view text, int line) {
    const std::string_view whole = line_of(text, line);
    const auto indentation = std::min(whole.find_first_not_of(" \t"), whole.size());
    if (const auto tab = whole.substr(0, indentation).find('\t');
        tab != whole.npos && indentation < whole.size())
        return YamlFault{"a tab in the indentation, allowed are spaces", line, static_cast<int>(tab) + 1};
    for (std::size_t at = 0; at < whole.size() && whole[at] != '#';) {
        const auto [code, bytes] = first_character(whole.substr(at));
        if (bytes > 1 && is_invisible(code))
            return YamlFault{
                fmt::format("the character U+{:04X}, which YAML takes for a letter, allowed is a plain space",
                            static_cast<std::uint32_t>(code)),
                line, characters_in(whole.substr(0, at)) + 1};
        at += std::max<std::size_t>(bytes, 1);
    }
    return std::nullopt;
}

}  // namespace

YamlFault yaml_fault(std::string_view text, std::string_view said, int line, int column) {
    for (const int suspect : {line - 1, line})
        if (suspect >= 1)
            if (auto found = blank_fault(text, suspect)) return *found;
    constexpr std::string_view escape = "unknown escape character: ";
    if (said.starts_with(escape))
        return {fmt::format("'\\{}' in double quotes is no escape; in single quotes '\\' stands for itself",
                            printable(said.substr(escape.size()))),
                line, column};
    for (const auto& [words, meaning] : meanings)
        if (said.starts_with(words)) return {std::string(meaning), line, column};
    return {std::string(said), line, column};
}

}  // namespace weavefront::scene
