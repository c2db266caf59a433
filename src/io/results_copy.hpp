#pragma once
/// @file
/// Frames moved to a results file with another room.

#include <cstdint>
#include <string>

#include "weavefront/io/results.hpp"

namespace weavefront::io {

/// Copies the topology and the first frames of a results file into the skeleton of another one, which counts
/// them afterwards; one process.
/// @param setup  of either file
/// @throws FileError
void copy_results(const std::string& from, const std::string& to, const ResultsSetup& setup,
                  std::int64_t frames);

}  // namespace weavefront::io
