#pragma once
/// @file
/// The directory a run writes to.

#include <filesystem>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Creates the directory with its parents where it does not exist yet, and makes sure that it can be written to.
/// @param directory  path, the same on all ranks
/// @param comm       ranks of the run
/// @throws FileError on all ranks when rank 0 cannot create it or must not write to it
/// @note Collective
void prepare_output_directory(const std::filesystem::path& directory, const parallel::Communicator& comm);

}  // namespace weavefront::io
