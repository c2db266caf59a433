#pragma once
/// @file
/// What a study says at its end.

#include <filesystem>
#include <span>

#include "measure.hpp"
#include "study_entries.hpp"
#include "weavefront/io/log.hpp"

namespace weavefront::app {

/// The table of errors and the orders of convergence.
void report_study(const scene::Study& study, std::span<const StudyEntry> entries, std::span<const StudyRow> rows, io::Log& log);

/// Compares a study.csv with one of before, row by row of its variants.
/// @throws GuardStop naming every quantity that is off by more than its tolerance, every outcome that differs and every variant that
/// `before`
///         lacks; std::runtime_error when a table cannot be read
void check_against_table(const scene::Study& study, const std::filesystem::path& table, const std::filesystem::path& before, io::Log& log);

}  // namespace weavefront::app
