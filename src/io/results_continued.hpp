#pragma once
/// @file
/// A results file that a run goes on with.

#include <cstdint>
#include <string>

#include "weavefront/io/results.hpp"

namespace weavefront::io {

/// Frames that the file has room for.
/// @param frames that it must hold
/// @throws FileError when it holds fewer, or has not the nodes and elements of `setup`
std::int64_t room_of_results(const std::string& path, const ResultsSetup& setup, std::int64_t frames);

/// The resolved scene that the file holds. @throws FileError
std::string scene_of_results(const std::string& path);

}  // namespace weavefront::io
