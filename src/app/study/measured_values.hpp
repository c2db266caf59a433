#pragma once
/// @file
/// Measured values that a study compares with.

#include <span>
#include <string>
#include <vector>

#include "study_entries.hpp"
#include "study_rows.hpp"
#include "weavefront/io/log.hpp"
#include "weavefront/study/curve.hpp"

namespace weavefront::app {

/// The columns of a file of measured values, found fit for the study.
/// @param text of the file
/// @throws scene::InputError with every finding as file:line:column: what is no finite number, a row cut
/// short, a column that is compared with nothing, times that do not ascend or that a variant does not share
study::Columns read_measured(const scene::Study& study, std::span<const StudyEntry> entries,
                             const std::string& text);

/// Says what is compared: ranges of times and of values with their units.
void report_measured(const scene::Study& study, std::span<const StudyEntry> entries,
                     const study::Columns& columns, io::Log& log);

/// Says the ranges of measured and computed values, and warns where they are of another size, as in another
/// unit.
void report_compared(const scene::Study& study, std::span<const StudyRow> rows, const study::Columns& columns,
                     io::Log& log);

}  // namespace weavefront::app
