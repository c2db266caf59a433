#pragma once
/// @file
/// What a study finds in the folders of its variants.

#include <filesystem>
#include <span>
#include <vector>

#include "study_entries.hpp"
#include "study_rows.hpp"
#include "weavefront/study/curve.hpp"

namespace weavefront::app {

/// Measures all entries.
/// @param measured what they are compared with where the reference is a file
/// @throws std::runtime_error for a file that cannot be read
std::vector<StudyRow> measure_study(const scene::Study& study, std::span<const StudyEntry> entries,
                                    const std::filesystem::path& folder, const study::Columns& measured);

}  // namespace weavefront::app
