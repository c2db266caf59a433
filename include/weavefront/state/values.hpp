#pragma once
/// @file
/// State that a run has once, as named values, and the archives that write and read it.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/state/table.hpp"

namespace weavefront::state {

/// A named value: numbers or text.
struct Value {
    std::string name;
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::string> content;
};

using Values = std::vector<Value>;

/// Writes values. Those of `sum` and `least` are of a rank and are brought together.
class ValueWriter {
  public:
    static constexpr bool reads = false;
    ValueWriter(Values& values, const parallel::Communicator& comm) : values_(&values), comm_(&comm) {}

    void operator()(std::string_view name, double& value) { add(name, std::vector{value}); }
    void operator()(std::string_view name, std::vector<double>& list) { add(name, list); }
    void operator()(std::string_view name, std::span<double> list) {
        add(name, std::vector<double>(list.begin(), list.end()));
    }
    void operator()(std::string_view name, std::int64_t& value) { add(name, std::vector{value}); }
    void operator()(std::string_view name, std::vector<std::int64_t>& list) { add(name, list); }
    void operator()(std::string_view name, int& value) { add(name, std::vector<std::int64_t>{value}); }
    void operator()(std::string_view name, bool& value) { add(name, std::vector<std::int64_t>{value}); }
    void operator()(std::string_view name, std::string& text) { add(name, text); }
    void operator()(std::string_view name, std::optional<double>& value) {
        add(name, value ? std::vector{*value} : std::vector<double>());
    }
    /// A part of a sum over the ranks. @note Collective
    void sum(std::string_view name, std::int64_t& part);
    /// Of each the least over the ranks counts. @note Collective
    void least(std::string_view name, std::span<double> list);

  private:
    template <class Content>
    void add(std::string_view name, Content content) {
        values_->push_back({std::string(name), std::move(content)});
    }
    Values* values_;
    const parallel::Communicator* comm_;
};

/// Reads values, the same on all ranks. @throws Mismatch when there is none of that name and kind
class ValueReader {
  public:
    static constexpr bool reads = true;
    ValueReader(const Values& values, const parallel::Communicator& comm) : values_(&values), comm_(&comm) {}

    void operator()(std::string_view name, double& value) { value = one<double>(name); }
    void operator()(std::string_view name, std::vector<double>& list) {
        list = get<std::vector<double>>(name);
    }
    /// @throws Mismatch also when there are more values, or fewer
    void operator()(std::string_view name, std::span<double> list);
    void operator()(std::string_view name, std::int64_t& value) { value = one<std::int64_t>(name); }
    void operator()(std::string_view name, std::vector<std::int64_t>& list) {
        list = get<std::vector<std::int64_t>>(name);
    }
    void operator()(std::string_view name, int& value) { value = static_cast<int>(one<std::int64_t>(name)); }
    void operator()(std::string_view name, bool& value) { value = one<std::int64_t>(name) != 0; }
    void operator()(std::string_view name, std::string& text) { text = get<std::string>(name); }
    void operator()(std::string_view name, std::optional<double>& value);
    /// The whole sum on the first rank, nothing on the others.
    void sum(std::string_view name, std::int64_t& part) {
        part = comm_->rank() == 0 ? one<std::int64_t>(name) : 0;
    }
    void least(std::string_view name, std::span<double> list) { (*this)(name, list); }

  private:
    template <class Content>
    [[nodiscard]] const Content& get(std::string_view name) const;
    template <class Number>
    [[nodiscard]] Number one(std::string_view name) const;

    const Values* values_;
    const parallel::Communicator* comm_;
};

}  // namespace weavefront::state
