#pragma once
/// @file
/// Two deformed targets compared.

#include <filesystem>

namespace weavefront::app {

/// How far apart the last plies of two runs are at a time: L2 norm over the ply of the difference in
/// displacement along z, over the norm of that of `reference`. Each is taken at its frame nearest to the time
/// and is bilinear in initial x and y between its nodes.
/// @param results, reference files results.vtkhdf of targets of one size @param time s
/// @throws io::FileError when a file cannot be read
double field_distance(const std::filesystem::path& results, const std::filesystem::path& reference,
                      double time);

}  // namespace weavefront::app
