#pragma once
/// @file
/// The option --set of the commands that read a scene.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace weavefront::app {

/// Adds `--set PATH=VALUE`. @param overrides receives them; outlives the command
inline void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
    command
        .add_option("--set", overrides,
                    "Override a value of the scene, PATH=VALUE; may be given several times")
        ->allow_extra_args(false);
}

}  // namespace weavefront::app
