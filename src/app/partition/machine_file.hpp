#pragma once
/// @file
/// The constants of a machine as JSON.

#include <string>

#include "weavefront/partition/machine.hpp"

namespace weavefront::app {

/// Reads what `machine_text` wrote.
/// @param name stands in messages
/// @throws scene::InputError when it is not JSON, a key is unknown or missing, or a value is not in its range
partition::Machine parse_machine(const std::string& text, const std::string& name);

/// One key a line, with units in the names.
std::string machine_text(const partition::Machine& machine);

}  // namespace weavefront::app
