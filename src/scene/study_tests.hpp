#pragma once
/// @file
/// The sections of a study file that say what to do with a yarn or a cell.

#include <filesystem>

#include "section.hpp"
#include "weavefront/scene/study.hpp"

namespace weavefront::scene {

/// `yarn` and `cell`: that of the computation must be there, the other must not.
struct Tests {
    YarnTest yarn;
    CellTest cell;
};

/// Reads both. @param folder that paths are relative to
Tests read_tests(Section& root, Compute compute, const std::filesystem::path& folder);

}  // namespace weavefront::scene
