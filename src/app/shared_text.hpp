#pragma once
/// @file
/// Files that all ranks need.

#include <filesystem>
#include <string>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

/// The text of a file, read by rank 0 alone. @param most bytes, see scene::read_text
/// @throws scene::InputError on all ranks when it cannot be read, is too long or no text
/// @note Collective
std::string shared_text(const std::filesystem::path& path, const parallel::Communicator& comm,
                        std::size_t most = scene::most_of_document);

/// Reads files that a scene names, by rank 0 alone: for `scene::parse_scene`, which all ranks call alike.
/// @note Each read is collective
scene::ReadFile shared_files(const parallel::Communicator& comm);

}  // namespace weavefront::app
