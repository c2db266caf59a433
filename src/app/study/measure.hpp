#pragma once
/// @file
/// What a study finds in the folders of its variants.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study_entries.hpp"

namespace weavefront::app {

/// The row of one variant.
struct StudyRow {
    std::string outcome;                        ///< finished or stopped
    std::string reason;                         ///< why
    std::vector<std::optional<double>> values;  ///< one a quantity, SI; none for histories and fields
    std::vector<std::optional<double>> errors;  ///< one a quantity, relative (absolute where the reference is zero); none without reference
    double wall_seconds = 0;                    ///< of the computation, without setting up
    std::int64_t element_steps = 0;
    int ranks = 1;
};

/// @param text of the file of measured values that a study compares with
/// @throws scene::InputError for a column that is compared with nothing, for times that do not ascend, and for what is no number
void require_measured(const scene::Study& study, const std::string& text);

/// Measures all entries. @throws std::runtime_error for a file that cannot be read
std::vector<StudyRow> measure_study(const scene::Study& study, std::span<const StudyEntry> entries, const std::filesystem::path& folder);

}  // namespace weavefront::app
