#include "usage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {
namespace {

void refuse_unless_known(std::string_view kind, const std::string& word,
                         const std::vector<std::string>& known) {
    if (std::ranges::find(known, word) != known.end()) return;
    const std::string hint = scene::nearest(word, known);
    const std::string question = hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint);
    throw scene::InputError(
        {fmt::format("{} '{}': unknown, allowed {}{}", kind, word, fmt::join(known, ", "), question)});
}

}  // namespace

void refuse_unknown(const KnownOptions& known, const std::vector<std::string>& subcommands,
                    std::span<const std::string> arguments) {
    std::string scope;
    for (const std::string& argument : arguments) {
        if (argument == "--") return;
        if (argument.starts_with("--")) {
            refuse_unless_known("option", argument.substr(0, argument.find('=')), known.at(scope));
        } else if (scope.empty() && !argument.starts_with('-')) {
            refuse_unless_known("subcommand", argument, subcommands);
            scope = argument;
        }
    }
}

}  // namespace weavefront::app
