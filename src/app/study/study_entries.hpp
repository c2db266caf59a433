#pragma once
/// @file
/// Everything that a study computes.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "weavefront/scene/study.hpp"

namespace weavefront::app {

/// A variant, or a reference that is none of the variants.
struct StudyEntry {
    scene::Variant variant;
    scene::Case input;
    bool reference_only = false;
    std::size_t reference =
        0;  ///< index of the entry that it is compared with; itself where that is not a variant
};

/// Variants in the order of their product, then the references that they need, each once.
/// @throws scene::InputError with every finding in any of them
std::vector<StudyEntry> study_entries(const scene::Study& study, const std::string& scene_text);

}  // namespace weavefront::app
