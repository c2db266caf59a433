#pragma once
/// @file
/// A CSV file as text.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace weavefront::study {

/// Header and rows; a row has as many cells as the header.
struct TextTable {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

/// A cell without blanks around it.
struct Cell {
    std::string text;
    std::size_t column;  ///< of its first character in the line, from 1
};

/// Cells of a line; quotes keep commas, and are doubled inside quotes. @param line without its end
std::vector<Cell> cells_of(std::string_view line);

/// Reads a CSV file.
/// @throws scene::InputError when it cannot be read or is empty, or a row has another number of cells
TextTable read_table(const std::filesystem::path& path);

/// The same from its text. @param name of the file, for messages
TextTable parse_table(const std::string& text, const std::string& name);

}  // namespace weavefront::study
