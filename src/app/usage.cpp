#include "usage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {
namespace {

constexpr std::array<std::string_view, 1> later_subcommands{"v50"};

void refuse_unless_known(std::string_view kind, const std::string& word,
                         const std::vector<std::string>& known,
                         std::span<const std::string_view> later = {}) {
    if (std::ranges::find(known, word) != known.end()) return;
    if (std::ranges::find(later, word) != later.end()) {
        throw scene::InputError({fmt::format("{} '{}': not available in this version", kind, word)});
    }
    const std::string hint = scene::nearest(word, known);
    const std::string question = hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint);
    throw scene::InputError(
        {fmt::format("{} '{}': unknown, allowed {}{}", kind, word, fmt::join(known, ", "), question)});
}

std::vector<std::string> long_options(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

}  // namespace

void refuse_unknown(const CLI::App& app, std::span<const std::string> arguments) {
    std::vector<std::string> subcommands;
    for (const CLI::App* subcommand : app.get_subcommands({})) subcommands.push_back(subcommand->get_name());

    const CLI::App* scope = &app;
    for (const std::string& argument : arguments) {
        if (argument == "--") return;
        if (argument.starts_with("--")) {
            refuse_unless_known("option", argument.substr(0, argument.find('=')), long_options(*scope));
        } else if (scope == &app && !argument.starts_with('-')) {
            refuse_unless_known("subcommand", argument, subcommands, later_subcommands);
            scope = app.get_subcommand(argument);
        }
    }
}

}  // namespace weavefront::app
