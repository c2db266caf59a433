#pragma once
/// @file
/// The command line of the program.

#include <string>
#include <vector>

namespace weavefront::app {

/// Parses the arguments and runs the subcommand that they name.
/// @param arguments without the name of the program
/// @throws scene::InputError for wrong usage, otherwise what the subcommand throws
void execute(const std::vector<std::string>& arguments);

}  // namespace weavefront::app
