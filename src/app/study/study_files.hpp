#pragma once
/// @file
/// study.csv and study.json.

#include <filesystem>
#include <span>

#include "measure.hpp"
#include "study_entries.hpp"

namespace weavefront::app {

/// Writes both, each as a whole or not at all. @throws io::FileError when one cannot be written
void write_study_files(const scene::Study& study, std::span<const StudyEntry> entries,
                       std::span<const StudyRow> rows, const std::filesystem::path& folder);

}  // namespace weavefront::app
