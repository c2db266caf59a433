#pragma once
/// @file
/// v50.csv: the shots as a range lists them, and the plan from which an interrupted `v50` goes on.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shot_row.hpp"
#include "v50_plan.hpp"

namespace weavefront::app {

/// The table: one row a shot, then the shots of the range.
std::string shot_table(const V50Plan& plan, std::span<const ShotRow> rows);

/// The shots that a table plans, without their results; those of the range are left out.
/// @param name of the file, for messages
/// @throws scene::InputError when it is no such table or holds shots of variants that the plan lacks
std::vector<ShotRow> planned_shots(const V50Plan& plan, const std::string& text, const std::string& name);

}  // namespace weavefront::app
