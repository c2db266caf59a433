#pragma once
/// @file
/// What a study says at its end.

#include <span>

#include "measure.hpp"
#include "study_entries.hpp"
#include "weavefront/io/log.hpp"

namespace weavefront::app {

/// The table of errors and the orders of convergence.
void report_study(const scene::Study& study, std::span<const StudyEntry> entries,
                  std::span<const StudyRow> rows, io::Log& log);

}  // namespace weavefront::app
