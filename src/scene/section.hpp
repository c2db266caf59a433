#pragma once
/// @file
/// Reads the keys of one map of the scene: each read states what is allowed, and what was never asked for is
/// an unknown key.

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "document.hpp"
#include "findings.hpp"
#include "names.hpp"
#include "units.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::scene {

/// Allowed values, SI.
struct Range {
    double low;
    bool low_included;
    double high;
    std::string_view text;          ///< as messages say it, after the dimension; the upper end is included
    std::string_view example = {};  ///< where that of the dimension is outside
};

inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr Range any_value{-unbounded, true, unbounded, ""};
inline constexpr Range positive{0, false, unbounded, " greater than 0"};
inline constexpr Range non_negative{0, true, unbounded, " of at least 0"};
inline constexpr Range at_least_one{1, true, unbounded, " of at least 1", "'1.5' or '150 %'"};

/// What all sections of a scene share.
struct Context {
    const Units& units = shared_units();
    Findings findings;
    ReadFile read_file;  ///< of files that the scene names
    MessageUnits message_units;
};

/// One map of the scene. Values that cannot be had are NaN (or the default), and a finding is noted.
class Section {
  public:
    /// @param value   the map; anything else is a finding
    /// @param where   what to point at when a key is missing
    /// @param path    keys from the root, with dots
    Section(const Value& value, Location where, std::string path, Context& context);

    /// Whether the key is there; asking makes it a known key.
    bool has(std::string_view key) { return entry(key) != nullptr; }
    bool has_list(std::string_view key);
    bool has_map(std::string_view key);
    bool has_text(std::string_view key);
    /// What the file holds under the key, for readers of their own; null when it is not there.
    const Entry* raw(std::string_view key) { return entry(key); }
    /// Whether the value is this word.
    bool says(std::string_view key, std::string_view word);

    /// A quantity in SI. @param otherwise its default; absent: the key is required
    double quantity(std::string_view key, const Dimension& dimension, const Range& range,
                    std::optional<double> otherwise = {});

    /// A list of N quantities of one dimension. @param otherwise its default; absent: the key is required
    template <std::size_t N>
    std::array<double, N> vector(std::string_view key, const Dimension& dimension, const Range& range,
                                 std::optional<std::array<double, N>> otherwise = {}) {
        std::array<double, N> values{};
        values.fill(std::numeric_limits<double>::quiet_NaN());
        if (!has(key) && otherwise) return *otherwise;
        components(key, dimension, range, values);
        return values;
    }

    /// A list of lists of N quantities of one dimension. @param most lists
    template <std::size_t N>
    std::vector<std::array<double, N>> vectors(std::string_view key, const Dimension& dimension,
                                               const Range& range, std::size_t most) {
        const Value* value = list_of_lists(key, N, most);
        std::vector<std::array<double, N>> all(value == nullptr ? 0 : value->items.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            components(value->items[i], inside(key) + "." + std::to_string(i), dimension, range, all[i]);
        return all;
    }

    /// A whole number from 1 to `high`.
    std::int64_t count(std::string_view key, std::int64_t high);

    /// Text. @param otherwise its default; absent: the key is required @param allowed what it is, in messages
    std::string text(std::string_view key, const std::optional<std::string>& otherwise = {},
                     std::string_view allowed = "text");

    /// Content of the file whose name stands under the key, which is there.
    /// @param most bytes
    /// @throws InputError when it cannot be read
    std::string file(std::string_view key, std::size_t most);

    /// One of a table of names. @param later names that a later version will serve, refused as such
    template <typename Table>
    auto choice(std::string_view key, const Table& table,
                std::optional<typename Table::value_type::second_type> otherwise = {},
                std::initializer_list<std::string_view> later = {}) {
        const Entry* found = entry(key);
        if (found == nullptr && otherwise) return *otherwise;
        const std::vector<std::string> names = names_in(table);
        const auto index =
            found == nullptr ? missing_name(key, names) : name_index(found->value, inside(key), names, later);
        return index ? table[*index].second : otherwise.value_or(table[0].second);
    }

    /// A list of different names of a table.
    template <typename Table>
    auto choices(std::string_view key, const Table& table,
                 std::vector<typename Table::value_type::second_type> otherwise) {
        if (!has(key)) return otherwise;
        otherwise.clear();
        for (const std::size_t index : name_list(key, names_in(table)))
            otherwise.push_back(table[index].second);
        return otherwise;
    }

    /// A map that must be there. @param read function of a Section&, whose result is returned
    /// @param allowed what it is, in messages, where users choose its keys; empty: a map with the keys that
    /// `read` asks for
    template <typename Read>
    auto required(std::string_view key, Read read, std::string_view allowed = {}) {
        const Entry* found = entry(key);
        if (found != nullptr) return within(found->value, found->where, inside(key), read, allowed);
        return absent(where_, inside(key), "nothing", read, allowed);
    }

    /// A map that may be left out.
    template <typename Read>
    auto optional(std::string_view key, Read read, std::string_view allowed = {})
        -> std::optional<std::invoke_result_t<Read, Section&>> {
        if (!has(key)) return std::nullopt;
        return required(key, read, allowed);
    }

    /// A list of maps; the results of reading each. @param read function of a Section&
    template <typename Read>
    auto list(std::string_view key, Read read) {
        std::vector<std::invoke_result_t<Read, Section&>> results;
        const Value& value = entry(key)->value;
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            const Value& item = value.items[i];
            results.push_back(within(item, item.where, inside(key) + "." + std::to_string(i), read, {}));
        }
        return results;
    }

    /// The keys of a map whose keys the user chooses.
    [[nodiscard]] std::vector<std::string> keys() const;

    /// Keys that a later version will serve: refused as such.
    void unavailable(std::initializer_list<std::string_view> later);
    /// Keys that name options of the command `run`: refused as such.
    void options_of_run(std::initializer_list<std::string_view> keys);

    /// Notes a finding about the value of a key (where the section stands when the key is absent) if
    /// `refused`.
    /// @param allowed what would have been
    void refuse_if(bool refused, std::string_view key, std::string_view allowed, std::string_view hint = {});

    /// Notes a finding about the value of a key in words of its own: where a bound is of what follows from
    /// the value.
    void refuse(std::string_view key, std::string_view found, std::string_view allowed);

    /// `refuse_if` about an item of the list under a key; about the list where it has no such item.
    void refuse_item_if(bool refused, std::string_view key, std::size_t item, std::string_view allowed);

    /// Ends the reading, with all findings up to here, where there is more than anybody means: reading on
    /// might take for ever.
    /// @param key whose value is counted; empty: this section itself
    /// @param of what is counted @throws InputError when `found` is more than `most`
    void require_at_most(std::string_view key, std::size_t found, std::size_t most, std::string_view of);

    /// The unit that the value of a key has, or else the one that the scene uses for that dimension: for
    /// bounds in messages.
    /// @param item of the list under the key, if it is one
    [[nodiscard]] MessageUnit unit_of(std::string_view key, const Dimension& dimension, std::size_t item = 0);

    /// Notes a finding for every key that was never asked for.
    void refuse_unknown();

  private:
    const Value* map_;
    Location where_;
    std::string path_;
    Context& context_;
    std::vector<std::string> known_;

    const Entry* entry(std::string_view key);
    /// Of a value, or of the section where there is none.
    [[nodiscard]] const Location& place_of(const Entry* entry) const;
    void refuse_all(std::initializer_list<std::string_view> keys, std::string_view reason);
    [[nodiscard]] std::string inside(std::string_view key) const;
    double read_quantity(const Value& value, const std::string& path, const Dimension& dimension,
                         const Range& range);
    void components(std::string_view key, const Dimension& dimension, const Range& range,
                    std::span<double> values);
    void components(const Value& list, const std::string& path, const Dimension& dimension,
                    const Range& range, std::span<double> values);
    /// The list under a key; null, with a finding, where there is none. @param items of each inner list
    const Value* list_of_lists(std::string_view key, std::size_t items, std::size_t most);
    std::optional<std::size_t> missing_name(std::string_view key, const std::vector<std::string>& names);
    std::optional<std::size_t> name_index(const Value& value, const std::string& path,
                                          const std::vector<std::string>& names,
                                          std::initializer_list<std::string_view> later = {});
    std::vector<std::size_t> name_list(std::string_view key, const std::vector<std::string>& names);
    [[nodiscard]] std::string known_keys() const;

    template <typename Read>
    auto within(const Value& value, const Location& where, const std::string& path, Read read,
                std::string_view allowed) {
        if (value.kind != Value::Kind::map) return absent(value.where, path, describe(value), read, allowed);
        Section section(value, where, path, context_);
        auto result = read(section);
        section.refuse_unknown();
        return result;
    }

    // The result of an empty map, so that one finding stands for all that is missing.
    template <typename Read>
    auto absent(const Location& where, const std::string& path, std::string_view found, Read read,
                std::string_view allowed) {
        static const Value empty(Value::Kind::map);
        const bool silent = context_.findings.silent();
        context_.findings.silence(true);
        Section section(empty, where, path, context_);
        auto result = read(section);
        context_.findings.silence(silent);
        context_.findings.add(
            where, path, found,
            allowed.empty() ? "a map with keys " + section.known_keys() : std::string(allowed));
        return result;
    }
};

}  // namespace weavefront::scene
