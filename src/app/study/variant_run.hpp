#pragma once
/// @file
/// One variant of a study: what it will cost, computing it, and whether that was done before.

#include <filesystem>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/study.hpp"
#include "weavefront/study/rank_plan.hpp"

namespace weavefront::app {

/// Expected element-steps and the most ranks of use.
study::Job job_of(scene::Compute compute, const scene::Case& variant);

/// Computes the variant into its folder, which exists: history.csv, summary.json and, of an impact,
/// results.vtkhdf and run.log. A run that the guard stops has an outcome too.
/// @note Collective
void compute_variant(scene::Compute compute, const scene::Case& variant, const std::filesystem::path& folder,
                     const parallel::Communicator& comm);

/// Whether the folder holds the outcome of just this variant, computed by this version of the program.
bool is_computed(scene::Compute compute, const scene::Case& variant, const std::filesystem::path& folder);

}  // namespace weavefront::app
