#pragma once
/// @file
/// Replaces objects of a checkpoint by others that HDF5 can read.

#include <hdf5.h>

#include "choices.hpp"

namespace weavefront::fuzz {

/// One replacement, chosen by the input, in an open file. Replacements that HDF5 refuses change nothing.
void edit_checkpoint(hid_t file, Choices& choices);

}  // namespace weavefront::fuzz
