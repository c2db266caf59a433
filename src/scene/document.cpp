#include "document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "weavefront/scene/read.hpp"

namespace weavefront::scene {
namespace {

[[noreturn]] void refuse(const Location& where, std::string_view what) { throw InputError({fmt::format("{}: {}", where.text, what)}); }

// yaml-cpp's own nodes drop repeated keys, so the tree is built from its events.
class TreeBuilder : public YAML::EventHandler {
  public:
    explicit TreeBuilder(const Locate& locate) : locate_(locate) {}
    Value root;
    int documents = 0;

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++documents > 1) refuse(at(mark), "found a second YAML document, allowed one");
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { close({.where = at(mark)}, anchor); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto known = anchors_.find(anchor);
        if (known == anchors_.end()) refuse(at(mark), "found an alias inside its own anchor");
        close(Value(known->second), 0);
    }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, const std::string& text) override {
        close({.kind = Value::Kind::scalar, .where = at(mark), .text = text}, anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, YAML::EmitterStyle::value) override {
        open_.push_back({{.kind = Value::Kind::list, .where = at(mark)}, std::nullopt, anchor});
    }
    void OnSequenceEnd() override { close_top(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, YAML::EmitterStyle::value) override {
        open_.push_back({{.kind = Value::Kind::map, .where = at(mark)}, std::nullopt, anchor});
    }
    void OnMapEnd() override { close_top(); }

  private:
    struct Open {
        Value value;
        std::optional<Entry> entry;  // of a map: its key has been seen, its value has not
        YAML::anchor_t anchor;
    };
    const Locate& locate_;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, Value> anchors_;

    [[nodiscard]] Location at(const YAML::Mark& mark) const { return locate_(mark.line + 1, mark.column + 1); }

    void close_top() {
        Open top = std::move(open_.back());
        open_.pop_back();
        close(std::move(top.value), top.anchor);
    }

    void close(Value value, YAML::anchor_t anchor) {
        if (anchor != 0) anchors_[anchor] = value;
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
            if (value.kind != Value::Kind::scalar) refuse(value.where, fmt::format("found {} as a key, allowed a name", describe(value)));
            parent.entry = Entry{.key = value.text, .where = value.where};
        }
    }
};

}  // namespace

Value parse_document(const std::string& text, const Locate& locate) {
    std::istringstream stream(text);
    TreeBuilder builder(locate);
    try {
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const YAML::Exception& error) {
        refuse(locate(error.mark.line + 1, error.mark.column + 1), "not YAML: " + error.msg);
    }
    return std::move(builder.root);
}

std::string describe(const Value& value) {
    switch (value.kind) {
        case Value::Kind::scalar:
            return fmt::format("'{}'", value.text);
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
