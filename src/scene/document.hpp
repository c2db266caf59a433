#pragma once
/// @file
/// A YAML document as a tree that remembers where everything stands and keeps keys given twice.

#include <functional>
#include <string>
#include <vector>

#include "findings.hpp"

namespace weavefront::scene {

struct Entry;

/// A node of the document.
struct Value {
    enum class Kind { null, scalar, list, map };

    explicit Value(Kind kind_of_node = Kind::null, Location location = {});

    Kind kind;
    Location where;
    std::string text;            ///< of a scalar
    std::vector<Value> items;    ///< of a list
    std::vector<Entry> entries;  ///< of a map, as written, after those of merge keys are added
    bool quoted = false;         ///< of a scalar
};

/// A key of a map and its value.
struct Entry {
    std::string key;
    Location where;
    Value value = Value();
    bool left_out = false;  ///< by an override without a value: as if it were not there
    bool quoted = false;
};

/// Turns a line and column (from 1) into a location.
using Locate = std::function<Location(int line, int column)>;

/// Parses one YAML document, with aliases and merge keys (`<<`) resolved.
/// @throws InputError with one message when it is not YAML, nested deeper than 64 levels, or of more than
/// 200000 values
Value parse_document(const std::string& text, const Locate& locate);

/// A value in a few words, for messages: `'3 kg'`, `a list`, `nothing`.
std::string describe(const Value& value);

/// The entry of a map with this key, or null. Of a key given twice, the first.
const Entry* find(const Value& map, std::string_view key);
Entry* find(Value& map, std::string_view key);

}  // namespace weavefront::scene
