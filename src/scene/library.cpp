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

std::vector<LibraryFabric> read_library() {
    const Value document = parse_document(library_text(), [](int line, int column) {
        return Location{"", line, column};
    });
    const auto& sources = find(document, "sources")->value;
    std::vector<LibraryFabric> fabrics;
    for (const auto& entry : find(document, "fabrics")->value.entries) {
        auto& fabric =
            fabrics.emplace_back(LibraryFabric{entry.key, find(entry.value, "title")->value.text, {}});
        for (const auto& value : find(entry.value, "values")->value.entries)
            fabric.values.push_back(value_of(value, sources));
    }
    return fabrics;
}

}  // namespace

const std::vector<LibraryFabric>& fabric_library() {
    static const std::vector<LibraryFabric> fabrics = read_library();
    return fabrics;
}

}  // namespace weavefront::scene
