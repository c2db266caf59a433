#pragma once
/// @file
/// The options `--checkpoint-every` and `--walltime`.

#include <string>

#include "checkpoint_schedule.hpp"

namespace weavefront::app {

/// Reads `10 min` or `5000 steps` into the plan. @return what is wrong with the text; empty: nothing
std::string read_checkpoint_interval(const std::string& text, CheckpointPlan& plan);

/// Reads `2 h` into the plan. @return what is wrong with the text; empty: nothing
std::string read_walltime(const std::string& text, CheckpointPlan& plan);

}  // namespace weavefront::app
