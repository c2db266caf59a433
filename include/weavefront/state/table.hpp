#pragma once
/// @file
/// State of many items as named columns, and the archives that write and read it.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace weavefront::state {

/// One named quantity of the items of a table.
struct Column {
    std::string name;                  ///< with the groups it is in, separated by dots
    std::vector<std::int32_t> counts;  ///< how many values each item has
    std::vector<double> values;        ///< of the items, one after the other
};

/// Items of one rank, such as its elements, by ascending global id, and their quantities.
struct Table {
    std::vector<std::int64_t> ids;
    std::vector<Column> columns;
};

/// A column is missing, or holds more or fewer values than the program asks for.
class Mismatch : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What both archives of a table share: the groups of names, and the search for a column.
class ColumnArchive {
  public:
    template <class Visit>
    void within(std::string_view group, Visit visit) {
        const auto length = group_.size();
        group_.append(group).append(".");
        visit();
        group_.resize(length);
    }

  protected:
    explicit ColumnArchive(Table& table) : table_(&table) {}

    /// Index of a column, or the number of columns. The one after the last is tried first.
    [[nodiscard]] std::size_t find(std::string_view name) {
        const auto count = table_->columns.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto at = (last_ + 1 + i) % count;
            if (is_named(table_->columns[at].name, name)) return last_ = at;
        }
        return count;
    }
    [[nodiscard]] std::string full_name(std::string_view name) const { return group_ + std::string(name); }

    Table* table_;
    std::size_t item_ = 0;

  private:
    [[nodiscard]] bool is_named(std::string_view column, std::string_view name) const {
        return column.size() == group_.size() + name.size() && column.ends_with(name) &&
               column.starts_with(group_);
    }
    std::string group_;
    std::size_t last_ = 0;
};

/// Writes the state of one item after the other into the columns of a table.
class ColumnWriter : public ColumnArchive {
  public:
    static constexpr bool reads = false;
    /// @param table with the ids of all items; columns are added as they are named
    explicit ColumnWriter(Table& table) : ColumnArchive(table) {}

    /// The values that follow are those of this item. @param item index in the table
    void start(std::size_t item) { item_ = item; }

    void operator()(std::string_view name, double& value) {
        auto at = find(name);
        if (at == table_->columns.size())
            table_->columns.push_back(
                {full_name(name), std::vector<std::int32_t>(table_->ids.size(), 0), {}});
        auto& column = table_->columns[at];
        column.values.push_back(value);
        ++column.counts[item_];
    }
    std::size_t size(std::string_view, std::size_t count) { return count; }
};

/// Reads the state of one item after the other from the columns of a table.
class ColumnReader : public ColumnArchive {
  public:
    static constexpr bool reads = true;
    explicit ColumnReader(Table& table) : ColumnArchive(table), next_(table.columns.size(), 0) {}

    /// @throws Mismatch when the item before has values that nobody took
    void start(std::size_t item) {
        finish();
        item_ = item;
        is_started_ = true;
        left_.clear();
        for (const auto& column : table_->columns) left_.push_back(column.counts[item]);
    }

    /// @throws Mismatch when the item has no more values of that name
    void operator()(std::string_view name, double& value) {
        const auto at = find(name);
        if (at == table_->columns.size() || left_[at] == 0)
            throw Mismatch("it holds no " + full_name(name) + " of item " +
                           std::to_string(table_->ids[item_]));
        --left_[at];
        value = table_->columns[at].values[next_[at]++];
    }

    /// How many values of this name the item has, by what is written.
    std::size_t size(std::string_view name, std::size_t) {
        const auto at = find(name);
        return at == table_->columns.size() ? 0 : static_cast<std::size_t>(left_[at]);
    }

    /// @throws Mismatch when the last item has values that nobody took
    void finish() {
        for (std::size_t c = 0; is_started_ && c < left_.size(); ++c)
            if (left_[c] != 0)
                throw Mismatch("it holds " + table_->columns[c].name + " of item " +
                               std::to_string(table_->ids[item_]) + ", which this program does not know");
    }

  private:
    std::vector<std::size_t> next_;   ///< value of each column
    std::vector<std::int32_t> left_;  ///< values of the item, of each column
    bool is_started_ = false;
};

}  // namespace weavefront::state
