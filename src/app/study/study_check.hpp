#pragma once
/// @file
/// `--check`: a study against its table of before.

#include <filesystem>
#include <span>
#include <vector>

#include "study_entries.hpp"
#include "weavefront/io/log.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {

/// Reads the study.csv of before.
/// @throws on all ranks std::runtime_error when it cannot be read or is no table; scene::InputError naming
/// everything that it lacks of
///         what is compared (columns, variants), and every cell that holds no number
/// @note Collective
study::TextTable table_of_before(const scene::Study& study, std::span<const StudyEntry> entries,
                                 const std::filesystem::path& path, const parallel::Communicator& comm);

/// Compares a study.csv with that of before, row by row of its variants.
/// @param before as of `table_of_before`
/// @param name of its file, for messages
/// @throws GuardStop naming every quantity that is off by more than its tolerance and every outcome that
/// differs
void check_against_table(const scene::Study& study, const std::filesystem::path& table,
                         const study::TextTable& before, const std::filesystem::path& name, io::Log& log);

}  // namespace weavefront::app
