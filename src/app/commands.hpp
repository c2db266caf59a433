#pragma once
/// @file
/// The subcommands. Each function adds one to the command line; its callback runs it and throws on failure.

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace weavefront::app {

/// A run stopped by the physics or numerics guard, exit status 1. scene::InputError exits with 2, every other
/// exception with 3.
class GuardStop : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A run that was asked to stop, exit status 4.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

void add_run(CLI::App& app);
void add_check(CLI::App& app);
void add_cell(CLI::App& app);
void add_yarn(CLI::App& app);
void add_study(CLI::App& app);
void add_partition(CLI::App& app);

}  // namespace weavefront::app
