#include "library_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "weavefront/scene/nearest.hpp"

namespace weavefront::scene {
namespace {

/// The value at a path with at most one dot, or null. A map that was left out holds nothing.
const Entry* at_path(const Value& map, std::string_view path) {
    const auto dot = path.find('.');
    const Entry* entry = find(map, path.substr(0, dot));
    if (entry == nullptr || dot == path.npos) return entry;
    if (entry->left_out || entry->value.kind != Value::Kind::map) return entry;
    return find(entry->value, path.substr(dot + 1));
}

void insert(Value& map, const LibraryValue& value, const Location& where) {
    const auto dot = value.key.find('.');
    const auto scalar = [&](const std::string& key) {
        Entry entry{.key = key, .where = where, .value = Value(Value::Kind::scalar, where)};
        entry.value.text = value.text;
        return entry;
    };
    if (dot == std::string::npos) {
        map.entries.push_back(scalar(value.key));
        return;
    }
    const auto parent = value.key.substr(0, dot);
    if (find(map, parent) == nullptr)
        map.entries.push_back({.key = parent, .where = where, .value = Value(Value::Kind::map, where)});
    find(map, parent)->value.entries.push_back(scalar(value.key.substr(dot + 1)));
}

void insert_all(Value& map, const LibraryEntry& library, const Location& where,
                std::span<const Replaced> replaced) {
    const auto own = map;
    const auto is_replaced = [&](const std::string& key) {
        return at_path(own, key) != nullptr || std::ranges::any_of(replaced, [&](const Replaced& pair) {
                   const Entry* entry = pair.library == key ? at_path(own, pair.scene) : nullptr;
                   return entry != nullptr && !entry->left_out;
               });
    };
    for (const auto& value : library.values)
        if (!is_replaced(value.key)) insert(map, value, where);
}

}  // namespace

void insert_from_library(Value& map, std::string_view key, std::string_view path, const Library& library,
                         std::span<const Replaced> replaced, Findings& findings) {
    const auto entry = std::ranges::find(map.entries, key, &Entry::key);
    if (entry == map.entries.end()) return;
    if (std::ranges::count(map.entries, key, &Entry::key) > 1) return;  // refused as a key given twice
    const Entry name = *entry;
    map.entries.erase(entry);
    if (name.left_out) return;
    const auto found = std::ranges::find(library, name.value.text, &LibraryEntry::name);
    if (name.value.kind == Value::Kind::scalar && found != library.end())
        return insert_all(map, *found, name.value.where, replaced);
    std::vector<std::string> names;
    for (const auto& known : library) names.push_back(known.name);
    findings.add(name.value.where, fmt::format("{}.{}", path, key), describe(name.value),
                 fmt::format("{}", fmt::join(names, ", ")),
                 name.value.kind == Value::Kind::scalar ? nearest(name.value.text, names) : "");
    findings.raise();
}

}  // namespace weavefront::scene
