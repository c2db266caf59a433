#pragma once
/// @file
/// Room on the disk for results.

#include <filesystem>

#include "weavefront/io/results.hpp"

namespace weavefront::io {

/// HDF5 does not survive a disk that is full at the wrong moment, and nobody wants to learn of it at the end
/// of a run.
/// @param bytes  that come free before the file has grown
/// @throws FileError when the disk cannot hold the file with all its frames
void require_space(const ResultsSetup& setup, double bytes);

/// Makes sure that the system takes a file of this size, as quotas and `ulimit -f` may not. @throws FileError
void require_size(const ResultsSetup& setup);

/// What the disk gets back when a file is replaced, bytes: results are sparse until they are written.
double taken_by(const std::filesystem::path& path);

}  // namespace weavefront::io
