#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "commands.hpp"
#include "weavefront/scene/library.hpp"
#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

/// Sources in the order in which the fabric names them, with their numbers.
std::vector<std::string> sources_of(const scene::LibraryFabric& fabric) {
    std::vector<std::string> sources;
    for (const auto& value : fabric.values)
        if (std::ranges::find(sources, value.source) == sources.end()) sources.push_back(value.source);
    return sources;
}

void print(const scene::LibraryFabric& fabric) {
    fmt::print("{}: {}\n", fabric.name, fabric.title);
    const auto sources = sources_of(fabric);
    for (const auto& value : fabric.values) {
        const auto number = std::ranges::find(sources, value.source) - sources.begin() + 1;
        const auto confidence =
            value.confidence ? fmt::format(", quoted from memory with confidence {}", *value.confidence) : "";
        fmt::print("  {:<24} {:<18} [{}]{}\n", value.key, value.text, number, confidence);
    }
    for (std::size_t i = 0; i < sources.size(); ++i) fmt::print("  [{}] {}\n", i + 1, sources[i]);
}

}  // namespace

void fabrics(const FabricsOptions& options) {
    const auto& library = scene::fabric_library();
    if (options.name.empty()) {
        for (const auto& fabric : library) {
            print(fabric);
            fmt::print("\n");
        }
        fmt::print("In a scene: fabrics: {{a: {{library: {}}}}}; further keys replace its values.\n",
                   library.front().name);
        return;
    }
    const auto found = std::ranges::find(library, options.name, &scene::LibraryFabric::name);
    if (found != library.end()) return print(*found);
    std::vector<std::string> names;
    for (const auto& fabric : library) names.push_back(fabric.name);
    const auto hint = scene::nearest(options.name, names);
    throw scene::InputError(
        {fmt::format("fabric '{}': unknown, allowed {}{}", options.name, fmt::join(names, ", "),
                     hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint))});
}

}  // namespace weavefront::app
