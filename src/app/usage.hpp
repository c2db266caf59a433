#pragma once
/// @file
/// Judges the command line before it is parsed.

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace weavefront::app {

/// Refuses a subcommand or a long option that does not exist, naming the nearest one, or the version that
/// lacks it.
/// @param app       with its subcommands
/// @param arguments of the command line, without the name of the program
/// @throws scene::InputError
void refuse_unknown(const CLI::App& app, std::span<const std::string> arguments);

}  // namespace weavefront::app
