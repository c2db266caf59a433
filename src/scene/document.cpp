#include "document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <unordered_set>
#include <utility>

#include "utf8.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "yaml_fault.hpp"

namespace weavefront::scene {
namespace {

// Deeper than any scene, far less than the parser's stack.
constexpr std::size_t most_levels = 64;

// Every alias is a copy: a few lines of aliases of aliases would fill any memory. 10000 listed plies have
// 40000 values.
constexpr std::size_t most_values = 200'000;

[[noreturn]] void refuse(const Location& where, std::string_view what) {
    throw InputError({fmt::format("{}: {}", where.text, what)});
}

/// The maps that a merge key names.
std::vector<Value> merged_maps(Entry entry) {
    std::vector<Value> maps;
    if (entry.value.kind == Value::Kind::list)
        maps = std::move(entry.value.items);
    else
        maps.push_back(std::move(entry.value));
    for (const Value& map : maps)
        if (map.kind != Value::Kind::map)
            refuse(map.where, fmt::format("<<: found {}, allowed a map or a list of maps, such as <<: *name",
                                          describe(map)));
    return maps;
}

/// Merge keys: `<<: *map`, or `<<: [*map, *other]`, gives a map the entries of others that it does not have
/// itself.
void merge(Value& map) {
    const auto is_merge = [](const Entry& entry) { return entry.key == "<<" && !entry.quoted; };
    if (std::ranges::none_of(map.entries, is_merge)) return;
    std::vector<Entry> own, merged;
    std::unordered_set<std::string> keys;
    for (Entry& entry : map.entries) {
        if (!is_merge(entry)) keys.insert(entry.key);
        (is_merge(entry) ? merged : own).push_back(std::move(entry));
    }
    for (Entry& entry : merged)
        for (Value& other : merged_maps(std::move(entry)))
            for (Entry& given : other.entries)
                if (keys.insert(given.key).second) own.push_back(std::move(given));
    map.entries = std::move(own);
}

/// Whether a text that begins with quotes has the quotes that close it. A text that begins otherwise has none
/// to close.
bool closes_quotes(std::string_view text) {
    if (text.empty() || (text.front() != '"' && text.front() != '\'')) return true;
    const char quote = text.front();
    for (std::size_t i = 1; i < text.size(); ++i) {
        const bool escape = quote == '"' && text[i] == '\\';
        const bool doubled = quote == '\'' && text[i] == quote && i + 1 < text.size() && text[i + 1] == quote;
        if (escape || doubled)
            ++i;
        else if (text[i] == quote)
            return true;
    }
    return false;
}

/// In characters from 1; yaml-cpp counts bytes.
int column_of(std::string_view text, const YAML::Mark& mark) {
    const std::string_view before = text.substr(0, static_cast<std::size_t>(mark.pos));
    const auto bytes = std::min(before.size(), static_cast<std::size_t>(mark.column));
    return 1 + characters_in(before.substr(before.size() - bytes));
}

// yaml-cpp's own nodes drop repeated keys, so the tree is built from its events.
class TreeBuilder : public YAML::EventHandler {
  public:
    TreeBuilder(std::string_view text, const Locate& locate) : text_(text), locate_(locate) {}
    Value root;
    int documents = 0;

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++documents > 1) refuse(at(mark), "found a second YAML document, allowed one");
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        count(1, at(mark));
        close(Value(Value::Kind::null, at(mark)), anchor);
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto known = anchors_.find(anchor);
        if (known == anchors_.end())
            refuse(at(mark), "found an alias inside its own anchor, allowed an alias after it");
        count(known->second.values, at(mark));
        close(Value(known->second.value), 0, known->second.values);
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& text) override {
        const bool quoted = tag == "!";
        count(1, at(mark));
        if (quoted) last_quoted_ = mark;
        Value scalar(Value::Kind::scalar, at(mark));
        scalar.text = text;
        scalar.quoted = quoted;
        close(std::move(scalar), anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(mark, Value::Kind::list, anchor);
    }
    void OnSequenceEnd() override { close_top(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(mark, Value::Kind::map, anchor);
    }
    void OnMapEnd() override {
        merge(open_.back().value);
        close_top();
    }

    /// yaml-cpp takes the end of the file for the end of a quoted text, which is the last one then.
    void require_closed_quotes() {
        if (last_quoted_.is_null() || closes_quotes(text_.substr(offset_of(last_quoted_)))) return;
        refuse(at(last_quoted_), "not YAML: a text in quotes is not closed");
    }

    /// yaml-cpp counts bytes, messages count characters.
    [[nodiscard]] Location at(const YAML::Mark& mark) {
        const std::size_t offset = offset_of(mark);
        if (mark.line != line_ || offset < counted_to_) {
            line_ = mark.line;
            counted_to_ = offset - std::min(offset, static_cast<std::size_t>(mark.column));
            characters_ = 0;
        }
        characters_ += characters_in(text_.substr(counted_to_, offset - counted_to_));
        counted_to_ = offset;
        return locate_(mark.line + 1, characters_ + 1);
    }

  private:
    struct Open {
        Value value;
        std::optional<Entry> entry;  // of a map: its key has been seen, its value has not
        YAML::anchor_t anchor;
        std::size_t values;  // itself and all below it so far
    };
    struct Anchored {
        Value value;
        std::size_t values;
    };
    std::string_view text_;
    const Locate& locate_;
    int line_ = -1, characters_ = 0;  // of the last place in the text
    std::size_t counted_to_ = 0;
    YAML::Mark last_quoted_ = YAML::Mark::null_mark();
    std::vector<Open> open_;
    std::map<YAML::anchor_t, Anchored> anchors_;
    std::size_t values_ = 0;

    [[nodiscard]] std::size_t offset_of(const YAML::Mark& mark) const {
        return std::min(static_cast<std::size_t>(mark.pos), text_.size());
    }

    void count(std::size_t values, const Location& where) {
        values_ += values;
        if (values_ > most_values)
            refuse(where,
                   fmt::format("found more than {0} values, repeated aliases included, allowed at most {0}",
                               most_values));
    }

    void open(const YAML::Mark& mark, Value::Kind kind, YAML::anchor_t anchor) {
        count(1, at(mark));
        if (open_.size() == most_levels)
            refuse(at(mark),
                   fmt::format("found lists and maps nested deeper than {0} levels, allowed at most {0}",
                               most_levels));
        open_.push_back({Value(kind, at(mark)), std::nullopt, anchor, 1});
    }

    void close_top() {
        Open top = std::move(open_.back());
        open_.pop_back();
        close(std::move(top.value), top.anchor, top.values);
    }

    void close(Value value, YAML::anchor_t anchor, std::size_t values = 1) {
        if (anchor != 0) anchors_[anchor] = {value, values};
        if (!open_.empty()) open_.back().values += values;
        if (open_.empty()) {
            root = std::move(value);
            return;
        }
        Open& parent = open_.back();
        if (parent.value.kind == Value::Kind::list) {
            parent.value.items.push_back(std::move(value));
        } else if (parent.entry) {
            parent.entry->value = std::move(value);
            parent.value.entries.push_back(std::move(*parent.entry));
            parent.entry.reset();
        } else {
            if (value.kind != Value::Kind::scalar)
                refuse(value.where, fmt::format("found {} as a key, allowed a name", describe(value)));
            parent.entry = Entry{.key = value.text, .where = value.where, .quoted = value.quoted};
        }
    }
};

}  // namespace

Value::Value(Kind kind_of_node, Location location) : kind(kind_of_node), where(std::move(location)) {}

Value parse_document(const std::string& text, const Locate& locate) {
    std::istringstream stream(text);
    TreeBuilder builder(text, locate);
    try {
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
        builder.require_closed_quotes();
    } catch (const YAML::Exception& error) {
        const YamlFault fault = yaml_fault(text, error.msg, error.mark.line + 1, column_of(text, error.mark));
        refuse(locate(fault.line, fault.column), "not YAML: " + fault.what);
    }
    return std::move(builder.root);
}

namespace {

bool looks_like_a_list(std::string_view text) {
    return text.size() > 1 &&
           ((text.front() == '[' && text.back() == ']') || (text.front() == '{' && text.back() == '}'));
}

}  // namespace

std::string describe(const Value& value) {
    switch (value.kind) {
        case Value::Kind::scalar:
            if (value.quoted && looks_like_a_list(value.text))
                return fmt::format("'{}' in quotes, which make it a text (did you mean it without them?)",
                                   printable(value.text));
            return fmt::format("'{}'", printable(value.text));
        case Value::Kind::list:
            return value.items.empty() ? "an empty list" : "a list";
        case Value::Kind::map:
            return value.entries.empty() ? "an empty map" : "a map of keys";
        case Value::Kind::null:
            break;
    }
    return "nothing";
}

const Entry* find(const Value& map, std::string_view key) {
    const auto entry = std::ranges::find(map.entries, key, &Entry::key);
    return entry == map.entries.end() ? nullptr : &*entry;
}

Entry* find(Value& map, std::string_view key) { return const_cast<Entry*>(find(std::as_const(map), key)); }

}  // namespace weavefront::scene
