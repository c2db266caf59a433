#include "weavefront/scene/library.hpp"

#include <charconv>

#include "document.hpp"
#include "library_text.hpp"

namespace weavefront::scene {
namespace {

LibraryValue value_of(const Entry& entry, const Value& sources) {
    const auto& items = entry.value.items;
    LibraryValue value{entry.key, items.at(0).text, find(sources, items.at(1).text)->value.text, {}};
    if (items.size() > 2) {
        double confidence = 0;
        const auto& text = items[2].text;
        std::from_chars(text.data(), text.data() + text.size(), confidence);
        value.confidence = confidence;
    }
    return value;
}

/// @param key of the entries
Library read_library(const std::string& text, std::string_view key) {
    const Value document = parse_document(text, [](int line, int column) {
        return Location{"", line, column};
    });
    const auto& sources = find(document, "sources")->value;
    Library library;
    for (const auto& entry : find(document, key)->value.entries) {
        auto& known =
            library.emplace_back(LibraryEntry{entry.key, find(entry.value, "title")->value.text, {}});
        for (const auto& value : find(entry.value, "values")->value.entries)
            known.values.push_back(value_of(value, sources));
    }
    return library;
}

}  // namespace

const Library& fabric_library() {
    static const Library fabrics = read_library(fabrics_text(), "fabrics");
    return fabrics;
}

const Library& projectile_library() {
    static const Library projectiles = read_library(projectiles_text(), "projectiles");
    return projectiles;
}

}  // namespace weavefront::scene
