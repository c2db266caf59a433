#pragma once
/// @file
/// Files that all ranks need.

#include <filesystem>
#include <string>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

/// The text of a file, read by rank 0 alone. @param most bytes, see scene::read_text
/// @throws scene::InputError on all ranks when it cannot be read, is too long or no text
/// @note Collective
std::string shared_text(const std::filesystem::path& path, const parallel::Communicator& comm,
                        std::size_t most = scene::most_of_document);

}  // namespace weavefront::app
