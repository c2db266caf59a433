#pragma once
/// @file
/// When, where and how a run was computed, for its run.log alone: no result depends on it, and no two runs
/// have it in common.

#include <string>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// The first lines: start with time zone, hosts and their ranks, command line, revision of the sources. @note
/// Collective
std::vector<std::string> run_head(const parallel::Communicator& comm);

/// The last line. @param seconds since the start
std::string run_tail(double seconds);

}  // namespace weavefront::app
