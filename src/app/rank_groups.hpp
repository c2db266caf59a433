#pragma once
/// @file
/// Groups of ranks that compute side by side.

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// The ranks of one colour. @note Collective
parallel::Communicator split(const parallel::Communicator& comm, int colour);

}  // namespace weavefront::app
