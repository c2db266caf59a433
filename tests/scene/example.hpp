#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "weavefront/scene/read.hpp"

namespace weavefront::scene::test {

inline std::string text_of_file(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + " cannot be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A scene that uses most keys.
inline const std::string example = text_of_file(WEAVEFRONT_SCENE_TESTS "/good.yaml");

/// A text with `from`, which must occur, replaced by `to`.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == text.npos) throw std::logic_error("the text has no '" + from + "'");
    return text.replace(at, from.size(), to);
}

/// The example with `from`, which must occur, replaced by `to`.
inline std::string example_with(const std::string& from, const std::string& to) {
    return with(example, from, to);
}

inline Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_scene(text, "s.yaml", overrides);
}

/// What parsing says is wrong; empty: nothing.
inline std::vector<std::string> findings(const std::string& text,
                                         const std::vector<std::string>& overrides = {},
                                         Need need = Need::impact) {
    try {
        parse_scene(text, "s.yaml", overrides, need);
    } catch (const InputError& error) {
        return error.messages();
    }
    return {};
}

}  // namespace weavefront::scene::test
