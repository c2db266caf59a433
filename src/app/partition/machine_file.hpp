#pragma once
/// @file
/// The constants of a machine as JSON.

#include <string>

#include "weavefront/partition/machine.hpp"

namespace weavefront::app {

/// Reads what `machine_text` wrote.
/// @param name stands in messages
/// @throws scene::InputError with every finding as `name:line:column`: not JSON, a key unknown, missing or
/// given twice, a value out of range
partition::Machine parse_machine(const std::string& text, const std::string& name);

/// One key a line, with units in the names.
std::string machine_text(const partition::Machine& machine);

}  // namespace weavefront::app
