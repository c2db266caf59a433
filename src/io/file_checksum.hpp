#pragma once
/// @file
/// A checksum at the end of a file, of everything before it.

#include <cstdint>
#include <string>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Appends the checksum of a whole file (XXH3), and waits until the file is on the disk.
/// @throws FileError on all ranks
/// @note Collective
void seal_file(const std::string& path, const parallel::Communicator& comm);

/// Makes sure that a file is what `seal_file` has left. @throws FileError on all ranks @note Collective
void require_sealed(const std::string& path, const parallel::Communicator& comm);

}  // namespace weavefront::io
