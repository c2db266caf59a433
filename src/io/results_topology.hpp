#pragma once
/// @file
/// What all frames of a results file share, written by all ranks.

#include <string>

#include "weavefront/io/block_exchange.hpp"
#include "weavefront/io/results.hpp"

namespace weavefront::io {

/// Writes the cells of both parts and the ply of each into the skeleton of a results file.
/// @param path      of the skeleton
/// @param setup     topology and surface
/// @param elements  exchange of the owned elements
/// @throws FileError
/// @note Collective
void write_topology(const std::string& path, const ResultsSetup& setup, const BlockExchange& elements,
                    const parallel::Communicator& comm);

}  // namespace weavefront::io
