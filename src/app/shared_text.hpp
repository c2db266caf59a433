#pragma once
/// @file
/// Files that all ranks need.

#include <filesystem>
#include <string>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// The text of a file, read by rank 0 alone. @throws std::runtime_error on all ranks when it cannot be read @note Collective
std::string shared_text(const std::filesystem::path& path, const parallel::Communicator& comm);

}  // namespace weavefront::app
