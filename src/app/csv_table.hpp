#pragma once
/// @file
/// A table written as CSV.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace weavefront::app {

/// Rows of numbers under a header, gathered in memory and written as a whole or not at all.
class CsvTable {
  public:
    /// @param header column names, separated by commas
    explicit CsvTable(std::string_view header);

    /// Adds a row. @param values one per column, written with 17 significant digits, which give back the same
    /// doubles
    /// @param cause what the row comes of, for a message; empty: its number
    /// @throws scene::InputError naming the column when one is not finite
    void add(std::span<const double> values, std::string_view cause = {});

    /// Writes the table under a temporary name and renames it.
    /// @throws std::runtime_error naming the file when it cannot be written
    void write(const std::filesystem::path& path) const;

    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::string header_, text_;
    std::size_t rows_ = 0;
};

}  // namespace weavefront::app
