#pragma once
/// @file
/// A CSV file as text.

#include <filesystem>
#include <string>
#include <vector>

namespace weavefront::study {

/// Header and rows; a row has as many cells as the header.
struct TextTable {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

/// Cells of a line; quotes keep commas, and are doubled inside quotes. @param line without its end
std::vector<std::string> cells_of(const std::string& line);

/// Reads a CSV file. @throws std::runtime_error when it cannot be read, is empty, or a row has other than the header's number of cells
TextTable read_table(const std::filesystem::path& path);

/// The same from its text. @param name of the file, for messages
TextTable parse_table(const std::string& text, const std::string& name);

}  // namespace weavefront::study
