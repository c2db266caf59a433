#pragma once
/// @file
/// An earlier `v50` in the same folder.

#include "v50_plan.hpp"

namespace weavefront::app {

/// Refuses a folder that holds a `v50`, makes sure that there is one to go on with, or removes its files, as
/// the options ask.
/// @throws scene::InputError, io::FileError on all ranks
/// @note Collective
void settle_earlier_v50(const V50Options& options, const V50Plan& plan, const parallel::Communicator& comm);

}  // namespace weavefront::app
