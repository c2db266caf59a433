#pragma once
/// @file
/// Computes what a study needs on the ranks that it was given.

#include <filesystem>
#include <span>

#include "study_entries.hpp"
#include "weavefront/io/log.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// Computes all entries that `folder` does not hold yet, each into the folder of its name. One line a
/// finished entry.
/// @throws std::runtime_error on all ranks when one could not be computed, after the others have been
/// @note Collective
void run_study(const scene::Study& study, std::span<const StudyEntry> entries,
               const std::filesystem::path& folder, const parallel::Communicator& comm, io::Log& log);

}  // namespace weavefront::app
