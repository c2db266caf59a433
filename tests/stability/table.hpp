#pragma once
/// @file
/// The stability table: one row a case and formulation.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "trial.hpp"

namespace weavefront::stability {

/// A case with what came of it.
struct Row {
    Case trial;
    std::string formulation;
    Result result;
    bool ok = true;
};

/// Largest energy error of a consistent run with a step at or below its bound, and most that a part of it may
/// give out of nothing.
inline constexpr double energy_tolerance = 0.02;

/// Whether the result is what the table says in advance. The paper's formulation has only to stay finite and
/// to end.
/// @param same the result whose bits this one must have; null: none
bool is_as_expected(const Case& trial, const std::string& formulation, const Result& result,
                    const Result* same);

/// One line of text. @param width of the first column
std::string text_of(const Row& row, std::size_t width);

/// One line a row, with a header. @throws std::runtime_error when the file cannot be written
void write_csv(const std::filesystem::path& file, const std::vector<Row>& rows);

/// One line a case, the paper's formulation beside the consistent one. @throws as write_csv
void write_markdown(const std::filesystem::path& file, const std::vector<Row>& rows);

}  // namespace weavefront::stability
