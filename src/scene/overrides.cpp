#include "overrides.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <utility>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

std::vector<std::string> split(const std::string& path) {
    std::vector<std::string> keys(1);
    for (const char c : path) {
        if (c == '.') {
            keys.emplace_back();
        } else {
            keys.back() += c;
        }
    }
    return keys;
}

constexpr std::size_t most_of_override = 300;  // characters, in messages

// Deeper than any scene: each is a level of the tree.
constexpr std::size_t most_keys = 16;

// What an override has come to on its way through the tree.
struct Cursor {
    const Location& where;
    const std::string& path;
    Findings& findings;
    std::size_t depth = 0;
    bool in_fabrics = false;
};

Value* list_item(Value& list, const std::string& key, const Cursor& cursor) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    if (error == std::errc{} && end == key.data() + key.size() && index < list.items.size())
        return &list.items[index];
    cursor.findings.add(cursor.where, printable(cursor.path), fmt::format("'{}'", printable(key)),
                        list.items.empty() ? "none: the list is empty"
                                           : fmt::format("an item from 0 to {}", list.items.size() - 1));
    return nullptr;
}

Entry* map_entry(Value& map, const std::string& key, bool last, const Cursor& cursor) {
    Entry* entry = find(map, key);
    if (entry != nullptr) return entry;
    if (cursor.in_fabrics && !last) {
        std::vector<std::string> names;
        for (const Entry& fabric : map.entries) names.push_back(fabric.key);
        cursor.findings.add(cursor.where, cursor.path, fmt::format("'{}'", key),
                            "the name of a fabric of the scene", nearest(key, names));
        return nullptr;
    }
    map.entries.push_back(
        {.key = key, .where = cursor.where, .value = Value(Value::Kind::null, cursor.where)});
    return &map.entries.back();
}

void place(Value& root, Value value, Cursor cursor) {
    const std::vector<std::string> keys = split(cursor.path);
    if (keys.size() > most_keys)
        return cursor.findings.add(cursor.where, "", fmt::format("a path of {} keys", keys.size()),
                                   fmt::format("at most {}", most_keys));
    Value* at = &root;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const bool last = i + 1 == keys.size();
        if (at->kind == Value::Kind::null) at->kind = Value::Kind::map;
        if (at->kind == Value::Kind::scalar) {
            cursor.findings.add(cursor.where, cursor.path,
                                fmt::format("'{}' below {}", keys[i], describe(*at)), "keys of a map only");
            return;
        }
        if (at->kind == Value::Kind::list) {
            at = list_item(*at, keys[i], cursor);
            if (at == nullptr) return;
            continue;
        }
        cursor.in_fabrics = i == 1 && keys[0] == "fabrics";
        Entry* entry = map_entry(*at, keys[i], last, cursor);
        if (entry == nullptr) return;
        entry->left_out = last && value.kind == Value::Kind::null;
        if (last) entry->where = cursor.where;
        at = &entry->value;
    }
    value.where = cursor.where;  // nothing has no place of its own
    *at = std::move(value);
}

void place_text(Value& root, const std::string& path, const std::string& value, const Location& where,
                Findings& findings) {
    try {
        place(root, parse_document(value, [&](int, int) { return where; }), {where, path, findings});
    } catch (const InputError& error) {
        findings.add(
            where, path,
            std::string_view(error.messages().front()).substr(where.text.size() + 2));  // after `where: `
    }
}

}  // namespace

void apply_settings(Value& root, std::span<const Setting> settings, Findings& findings) {
    int order = 0;
    for (const Setting& setting : settings) {
        const Location where{
            .text = setting.where, .line = std::numeric_limits<int>::max(), .column = ++order};
        place_text(root, setting.path, setting.value, where, findings);
    }
}

void apply_overrides(Value& root, const std::vector<std::string>& overrides, Findings& findings) {
    int order = 0;
    for (const std::string& text : overrides) {
        const Location where{.text = "--set " + printable(text, most_of_override),
                             .line = std::numeric_limits<int>::max(),
                             .column = ++order};
        std::size_t at = 0;
        if (const std::string fault = fault_of_text(text, at); !fault.empty()) {
            findings.add(where, "", fmt::format("found {}", fault));
            continue;
        }
        const std::size_t equals = text.find('=');
        if (equals == text.npos || equals == 0) {
            findings.add(where, "", "no PATH=VALUE", "an assignment, such as projectile.mass='2.8 g'");
            continue;
        }
        place_text(root, text.substr(0, equals), text.substr(equals + 1), where, findings);
    }
}

}  // namespace weavefront::scene
