#include "library_fabrics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "weavefront/scene/library.hpp"
#include "weavefront/scene/nearest.hpp"

namespace weavefront::scene {
namespace {

/// Keys of the scene, and keys of the library that they leave without a meaning.
constexpr std::array<std::pair<std::string_view, std::string_view>, 21> replaced{{
    {"count", "yarn.span"},
    {"yarn.span", "count"},
    {"yarn.area", "yarn.denier"},
    {"yarn.area", "yarn.dtex"},
    {"yarn.denier", "yarn.area"},
    {"yarn.denier", "yarn.dtex"},
    {"yarn.dtex", "yarn.area"},
    {"yarn.dtex", "yarn.denier"},
    {"crimp", "thickness"},
    {"crimp_height", "thickness"},
    {"count", "areal_density"},
    {"yarn.span", "areal_density"},
    {"yarn.denier", "areal_density"},
    {"yarn.dtex", "areal_density"},
    {"elastic.modulus", "elastic.static_modulus"},
    {"elastic.modulus", "elastic.hooke_modulus"},
    {"elastic.modulus", "elastic.viscosity"},
    {"elastic.static_modulus", "elastic.modulus"},
    {"failure.strain", "failure.static_strain"},
    {"failure.strain", "failure.hooke_strain"},
    {"failure.static_strain", "failure.strain"},
}};

/// The value at a path with at most one dot, or null. A map that was left out holds nothing.
const Entry* at_path(const Value& fabric, std::string_view path) {
    const auto dot = path.find('.');
    const Entry* entry = find(fabric, path.substr(0, dot));
    if (entry == nullptr || dot == path.npos) return entry;
    if (entry->left_out || entry->value.kind != Value::Kind::map) return entry;
    return find(entry->value, path.substr(dot + 1));
}

void insert(Value& fabric, const LibraryValue& value, const Location& where) {
    const auto dot = value.key.find('.');
    const auto scalar = [&](const std::string& key) {
        Entry entry{.key = key, .where = where, .value = Value(Value::Kind::scalar, where)};
        entry.value.text = value.text;
        return entry;
    };
    if (dot == std::string::npos) {
        fabric.entries.push_back(scalar(value.key));
        return;
    }
    const auto parent = value.key.substr(0, dot);
    if (find(fabric, parent) == nullptr)
        fabric.entries.push_back({.key = parent, .where = where, .value = Value(Value::Kind::map, where)});
    find(fabric, parent)->value.entries.push_back(scalar(value.key.substr(dot + 1)));
}

void insert_all(Value& fabric, const LibraryFabric& library, const Location& where) {
    const auto own = fabric;
    const auto is_replaced = [&](const std::string& key) {
        return at_path(own, key) != nullptr || std::ranges::any_of(replaced, [&](const auto& pair) {
                   const Entry* entry = pair.second == key ? at_path(own, pair.first) : nullptr;
                   return entry != nullptr && !entry->left_out;
               });
    };
    for (const auto& value : library.values)
        if (!is_replaced(value.key)) insert(fabric, value, where);
}

}  // namespace

void insert_library_fabrics(Value& scene, Findings& findings) {
    Entry* fabrics = scene.kind == Value::Kind::map ? find(scene, "fabrics") : nullptr;
    if (fabrics == nullptr || fabrics->value.kind != Value::Kind::map) return;
    for (auto& [key, where, fabric, left_out, quoted] : fabrics->value.entries) {
        if (fabric.kind != Value::Kind::map) continue;
        const auto entry = std::ranges::find(fabric.entries, "library", &Entry::key);
        if (entry == fabric.entries.end()) continue;
        if (std::ranges::count(fabric.entries, "library", &Entry::key) > 1)
            continue;  // refused as a key given twice
        const Entry name = *entry;
        fabric.entries.erase(entry);
        if (name.left_out) continue;
        const auto& library = fabric_library();
        const auto found = std::ranges::find(library, name.value.text, &LibraryFabric::name);
        if (name.value.kind == Value::Kind::scalar && found != library.end()) {
            insert_all(fabric, *found, name.value.where);
            continue;
        }
        std::vector<std::string> names;
        for (const auto& known : library) names.push_back(known.name);
        findings.add(name.value.where, fmt::format("fabrics.{}.library", key), describe(name.value),
                     fmt::format("{}", fmt::join(names, ", ")),
                     name.value.kind == Value::Kind::scalar ? nearest(name.value.text, names) : "");
        findings.raise();
    }
}

}  // namespace weavefront::scene
