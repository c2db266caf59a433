#include "section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <unordered_map>
#include <unordered_set>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

constexpr std::string_view later_version = "not available in this version";

std::string allowed_quantity(const Dimension& dimension, const Range& range) {
    return fmt::format("{}{}, such as {}", dimension.name, range.text,
                       range.example.empty() ? dimension.example : range.example);
}

std::string allowed_list(std::size_t items, const Dimension& dimension, const Range& range) {
    return fmt::format("a list of {}, each {}", items, allowed_quantity(dimension, range));
}

std::optional<MessageUnit> written_unit(const Value& value, const Dimension& dimension, const Units& units) {
    const Quantity quantity =
        value.kind == Value::Kind::scalar ? units.read(value.text, dimension) : Quantity{};
    if (!quantity.problem.empty() || quantity.unit.empty()) return std::nullopt;
    return MessageUnit{quantity.unit, units.read("1 " + quantity.unit, dimension).value, true};
}

}  // namespace

Section::Section(const Value& value, Location where, std::string path, Context& context)
    : map_(&value), where_(std::move(where)), path_(std::move(path)), context_(context) {
    std::unordered_map<std::string_view, const Entry*> firsts;
    for (const Entry& candidate : map_->entries) {
        const auto [first, is_new] = firsts.try_emplace(candidate.key, &candidate);
        if (!is_new)
            context_.findings.add(candidate.where, inside(candidate.key),
                                  "the key again, first at " + first->second->where.text, "once");
    }
}

bool Section::has_list(std::string_view key) {
    const Entry* found = entry(key);
    return found != nullptr && found->value.kind == Value::Kind::list;
}

bool Section::has_map(std::string_view key) {
    const Entry* found = entry(key);
    return found != nullptr && found->value.kind == Value::Kind::map;
}

bool Section::has_text(std::string_view key) {
    const Entry* found = entry(key);
    return found != nullptr && found->value.kind == Value::Kind::scalar;
}

bool Section::says(std::string_view key, std::string_view word) {
    const Entry* found = entry(key);
    return found != nullptr && found->value.kind == Value::Kind::scalar && found->value.text == word;
}

const Entry* Section::entry(std::string_view key) {
    if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
    const Entry* found = find(*map_, key);
    return found == nullptr || found->left_out ? nullptr : found;
}

std::string Section::inside(std::string_view key) const {
    return path_.empty() ? printable(key) : fmt::format("{}.{}", path_, printable(key));
}

double Section::quantity(std::string_view key, const Dimension& dimension, const Range& range,
                         std::optional<double> otherwise) {
    const Entry* found = entry(key);
    if (found != nullptr) return read_quantity(found->value, inside(key), dimension, range);
    if (!otherwise) context_.findings.add(where_, inside(key), "nothing", allowed_quantity(dimension, range));
    return otherwise.value_or(std::numeric_limits<double>::quiet_NaN());
}

double Section::read_quantity(const Value& value, const std::string& path, const Dimension& dimension,
                              const Range& range) {
    std::string found = describe(value), meant;
    if (value.kind == Value::Kind::scalar) {
        const Quantity quantity = context_.units.read(value.text, dimension);
        const bool low = range.low_included ? quantity.value < range.low : quantity.value <= range.low;
        if (quantity.problem.empty() && !low && quantity.value <= range.high) {
            if (dimension.unit != nullptr && !(context_.message_units.*dimension.unit).written)
                if (auto unit = written_unit(value, dimension, context_.units))
                    context_.message_units.*dimension.unit = std::move(*unit);
            return quantity.value;
        }
        if (!quantity.problem.empty()) found += ", " + quantity.problem;
        meant = quantity.nearest;
    }
    context_.findings.add(value.where, path, found, allowed_quantity(dimension, range), meant);
    return std::numeric_limits<double>::quiet_NaN();
}

void Section::components(std::string_view key, const Dimension& dimension, const Range& range,
                         std::span<double> values) {
    const Entry* found = entry(key);
    if (found == nullptr)
        return context_.findings.add(where_, inside(key), "nothing",
                                     allowed_list(values.size(), dimension, range));
    components(found->value, inside(key), dimension, range, values);
}

void Section::components(const Value& list, const std::string& path, const Dimension& dimension,
                         const Range& range, std::span<double> values) {
    const std::string allowed = allowed_list(values.size(), dimension, range);
    if (list.kind != Value::Kind::list)
        return context_.findings.add(list.where, path, describe(list), allowed);
    if (list.items.size() != values.size())
        return context_.findings.add(list.where, path, fmt::format("a list of {}", list.items.size()),
                                     allowed);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = read_quantity(list.items[i], fmt::format("{}.{}", path, i), dimension, range);
}

const Value* Section::list_of_lists(std::string_view key, std::size_t items, std::size_t most) {
    const Entry* found = entry(key);
    const std::string allowed = fmt::format("a list of lists of {}", items);
    if (found == nullptr)
        context_.findings.add(where_, inside(key), "nothing", allowed);
    else if (found->value.kind != Value::Kind::list)
        context_.findings.add(found->value.where, inside(key), describe(found->value), allowed);
    else {
        require_at_most(key, found->value.items.size(), most, "lists");
        return &found->value;
    }
    return nullptr;
}

std::int64_t Section::count(std::string_view key, std::int64_t high) {
    const Entry* found = entry(key);
    const std::string allowed = fmt::format("a whole number from 1 to {}", high);
    if (found == nullptr) {
        context_.findings.add(where_, inside(key), "nothing", allowed);
        return 1;
    }
    const std::string& digits = found->value.text;
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc{} && end == digits.data() + digits.size() && value >= 1 && value <= high)
        return value;
    context_.findings.add(found->value.where, inside(key), describe(found->value), allowed);
    return 1;
}

std::string Section::text(std::string_view key, const std::optional<std::string>& otherwise,
                          std::string_view allowed) {
    const Entry* found = entry(key);
    if (found == nullptr) {
        if (!otherwise) context_.findings.add(where_, inside(key), "nothing", allowed);
    } else if (found->value.kind == Value::Kind::scalar) {
        return found->value.text;
    } else {
        context_.findings.add(found->value.where, inside(key), describe(found->value), allowed);
    }
    return otherwise.value_or("");
}

std::string Section::file(std::string_view key, std::size_t most) {
    const Entry* found = entry(key);
    if (found->value.kind != Value::Kind::scalar || found->value.text.empty()) {
        context_.findings.add(found->value.where, inside(key), describe(found->value), "the name of a file");
        return {};
    }
    return context_.read_file(found->value.text, most);
}

std::optional<std::size_t> Section::missing_name(std::string_view key,
                                                 const std::vector<std::string>& names) {
    context_.findings.add(where_, inside(key), "nothing", fmt::format("{}", fmt::join(names, ", ")));
    return std::nullopt;
}

std::optional<std::size_t> Section::name_index(const Value& value, const std::string& path,
                                               const std::vector<std::string>& names,
                                               std::initializer_list<std::string_view> later) {
    const auto known = std::ranges::find(names, value.text);
    if (value.kind == Value::Kind::scalar && known != names.end())
        return static_cast<std::size_t>(known - names.begin());
    const std::string allowed = fmt::format("{}", fmt::join(names, ", "));
    if (value.kind == Value::Kind::scalar && std::ranges::find(later, value.text) != later.end()) {
        context_.findings.add(value.where, path, fmt::format("{}, {}", describe(value), later_version),
                              allowed);
    } else {
        context_.findings.add(value.where, path, describe(value), allowed, nearest(value.text, names));
    }
    return std::nullopt;
}

std::vector<std::size_t> Section::name_list(std::string_view key, const std::vector<std::string>& names) {
    const Value& list = entry(key)->value;
    std::vector<std::size_t> indices;
    if (list.kind != Value::Kind::list) {
        context_.findings.add(list.where, inside(key), describe(list),
                              fmt::format("a list of {}", fmt::join(names, ", ")));
    }
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const std::string path = fmt::format("{}.{}", inside(key), i);
        const auto index = name_index(list.items[i], path, names);
        if (!index) continue;
        const bool again = std::ranges::find(indices, *index) != indices.end();
        if (again)
            context_.findings.add(list.items[i].where, path, fmt::format("'{}' again", names[*index]),
                                  "each name once");
        indices.push_back(*index);
    }
    return indices;
}

std::vector<std::string> Section::keys() const {
    std::vector<std::string> keys;
    std::unordered_set<std::string_view> seen;
    for (const Entry& candidate : map_->entries) {
        if (seen.insert(candidate.key).second && !candidate.left_out) keys.push_back(candidate.key);
    }
    return keys;
}

void Section::unavailable(std::initializer_list<std::string_view> later) { refuse_all(later, later_version); }

void Section::refuse_all(std::initializer_list<std::string_view> keys, std::string_view reason) {
    for (const std::string_view key : keys) {
        const Entry* found = find(*map_, key);
        if (found == nullptr) continue;
        known_.emplace_back(key);
        context_.findings.add(found->where, inside(key), std::string(reason));
    }
}

void Section::options_of_run(std::initializer_list<std::string_view> keys) {
    refuse_all(
        keys,
        "no key of a scene: options of weavefront run are --checkpoint-every, --walltime and --restart");
}

const Location& Section::place_of(const Entry* entry) const {
    if (entry == nullptr) return where_;
    const bool map = entry->value.kind == Value::Kind::map;  // begins on the line after its key, often
    return map ? entry->where : entry->value.where;
}

void Section::refuse_if(bool refused, std::string_view key, std::string_view allowed, std::string_view hint) {
    if (!refused) return;
    const Entry* found = entry(key);
    context_.findings.add(place_of(found), inside(key), found == nullptr ? "nothing" : describe(found->value),
                          allowed, hint);
}

void Section::refuse_item_if(bool refused, std::string_view key, std::size_t item, std::string_view allowed) {
    if (!refused) return;
    const Entry* found = entry(key);
    if (found == nullptr || item >= found->value.items.size()) return refuse_if(true, key, allowed);
    const Value& value = found->value.items[item];
    context_.findings.add(value.where, fmt::format("{}.{}", inside(key), item), describe(value), allowed);
}

void Section::refuse(std::string_view key, std::string_view found, std::string_view allowed) {
    context_.findings.add(place_of(entry(key)), inside(key), found, allowed);
}

void Section::require_at_most(std::string_view key, std::size_t found, std::size_t most,
                              std::string_view of) {
    if (found <= most) return;
    context_.findings.silence(false);
    const Location& where = key.empty() ? where_ : entry(key)->value.where;
    context_.findings.add(where, key.empty() ? path_ : inside(key), fmt::format("{} {}", found, of),
                          fmt::format("at most {}", most));
    context_.findings.raise();
}

MessageUnit Section::unit_of(std::string_view key, const Dimension& dimension, std::size_t item) {
    if (const Entry* found = entry(key)) {
        const Value& value = item < found->value.items.size() ? found->value.items[item] : found->value;
        if (auto unit = written_unit(value, dimension, context_.units)) return *unit;
    }
    return context_.message_units.*dimension.unit;
}

void Section::refuse_unknown() {
    // Maps whose keys the user chooses may have many.
    const std::unordered_set<std::string_view> known(known_.begin(), known_.end());
    for (const Entry& candidate : map_->entries) {
        if (known.contains(candidate.key)) continue;
        if (context_.findings.full())
            context_.findings.count(1);
        else
            context_.findings.add(candidate.where, inside(candidate.key), "an unknown key", known_keys(),
                                  nearest(candidate.key, known_));
    }
}

std::string Section::known_keys() const { return fmt::format("{}", fmt::join(known_, ", ")); }

}  // namespace weavefront::scene
