#pragma once
/// @file
/// Lists of items in compressed rows.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace weavefront::mesh {

/// Rows of items in two arrays: row r holds items [offsets[r], offsets[r + 1]).
///
/// Rows are built in order, item by item, or all at once from entries in any order. `Offset` is an integer
/// that can count all items.
template <class Item, class Offset = std::int32_t>
class AdjacencyList {
  public:
    AdjacencyList() = default;

    /// Sorts entries into rows. The entries of a row keep their order.
    /// @param rows           number of rows
    /// @param for_each_entry called twice with a function `use(row, item)`; calls it for the same entries
    /// both
    ///                       times
    template <class ForEachEntry>
    AdjacencyList(std::size_t rows, const ForEachEntry& for_each_entry) : offsets_(rows + 2, 0) {
        // Entry r + 2 counts row r, then entry r + 1 is the end of what is already in row r.
        for_each_entry([&](std::integral auto row, const Item&) { ++offsets_[index(row) + 2]; });
        std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
        items_.resize(static_cast<std::size_t>(offsets_.back()));
        for_each_entry([&](std::integral auto row, const Item& item) {
            items_[static_cast<std::size_t>(offsets_[index(row) + 1]++)] = item;
        });
        offsets_.pop_back();
    }

    /// Number of rows, without the one that is being built.
    [[nodiscard]] std::size_t rows() const { return offsets_.size() - 1; }

    /// Items of a row. @pre row < rows()
    [[nodiscard]] std::span<const Item> operator[](std::integral auto row) const {
        return std::span(items_).subspan(begin(index(row)), begin(index(row) + 1) - begin(index(row)));
    }
    [[nodiscard]] std::span<Item> operator[](std::integral auto row) {
        return std::span(items_).subspan(begin(index(row)), begin(index(row) + 1) - begin(index(row)));
    }

    /// First item of each row, and the number of all items.
    [[nodiscard]] std::span<const Offset> offsets() const { return offsets_; }
    /// Items of all rows.
    [[nodiscard]] std::span<const Item> items() const { return items_; }

    /// Appends an item to the row that is being built.
    void push_back(const Item& item) { items_.push_back(item); }
    /// Items of the row that is being built.
    [[nodiscard]] std::span<Item> open_row() { return std::span(items_).subspan(begin(rows())); }
    /// Ends the row that is being built.
    void end_row() { offsets_.push_back(static_cast<Offset>(items_.size())); }

    /// Drops all rows from `rows` on, and the one that is being built. @pre rows <= rows()
    void truncate(std::size_t rows) {
        offsets_.resize(rows + 1);
        items_.resize(static_cast<std::size_t>(offsets_.back()));
    }
    void reserve_rows(std::size_t rows) { offsets_.reserve(rows + 1); }
    /// Frees the memory of items to come.
    void shrink_to_fit() { items_.shrink_to_fit(); }

  private:
    static std::size_t index(std::integral auto row) { return static_cast<std::size_t>(row); }
    [[nodiscard]] std::size_t begin(std::size_t row) const { return static_cast<std::size_t>(offsets_[row]); }

    std::vector<Offset> offsets_{0};
    std::vector<Item> items_;
};

}  // namespace weavefront::mesh
