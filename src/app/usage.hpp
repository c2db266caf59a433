#pragma once
/// @file
/// Judges the command line before it is parsed.

#include <map>
#include <span>
#include <string>
#include <vector>

namespace weavefront::app {

/// Long options of each subcommand, `--output`; those of the program itself stand under an empty name.
using KnownOptions = std::map<std::string, std::vector<std::string>>;

/// Refuses a subcommand or a long option that does not exist, naming the nearest one.
/// @param subcommands in the order in which they are listed
/// @param arguments   of the command line, without the name of the program
/// @throws scene::InputError
void refuse_unknown(const KnownOptions& known, const std::vector<std::string>& subcommands,
                    std::span<const std::string> arguments);

}  // namespace weavefront::app
