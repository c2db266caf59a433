#pragma once
/// @file
/// The result of a shot, read from its folder.

#include <array>
#include <filesystem>

#include "criterion.hpp"
#include "shot_row.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// Whether a finished run of this scene and this version is in the folder, with files as they were written.
bool is_shot_computed(const scene::Scene& scene, const std::filesystem::path& folder);

/// Fills the result of a row from summary.json and history.csv. A shot without a summary was not computed:
/// the row keeps what it says.
/// @param direction of the shot, unit vector
/// @throws std::runtime_error when a file cannot be read
void read_shot(const std::filesystem::path& folder, const Criterion& criterion,
               const std::array<double, 3>& direction, ShotRow& row);

}  // namespace weavefront::app
