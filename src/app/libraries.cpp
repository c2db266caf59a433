#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "weavefront/scene/library.hpp"
#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

/// Sources in the order in which an entry names them, with their numbers.
std::vector<std::string> sources_of(const scene::LibraryEntry& entry) {
    std::vector<std::string> sources;
    for (const auto& value : entry.values)
        if (std::ranges::find(sources, value.source) == sources.end()) sources.push_back(value.source);
    return sources;
}

void print(const scene::LibraryEntry& entry) {
    fmt::print("{}: {}\n", entry.name, entry.title);
    const auto sources = sources_of(entry);
    for (const auto& value : entry.values) {
        const auto number = std::ranges::find(sources, value.source) - sources.begin() + 1;
        const auto confidence =
            value.confidence ? fmt::format(", quoted from memory with confidence {}", *value.confidence) : "";
        fmt::print("  {:<24} {:<18} [{}]{}\n", value.key, value.text, number, confidence);
    }
    for (std::size_t i = 0; i < sources.size(); ++i) fmt::print("  [{}] {}\n", i + 1, sources[i]);
}

/// @param kind of the entries, in messages @param use how a scene takes an entry
void list(const scene::Library& library, const std::string& name, std::string_view kind,
          const std::string& use) {
    if (name.empty()) {
        for (const auto& entry : library) {
            print(entry);
            fmt::print("\n");
        }
        fmt::print("In a scene: {}; further keys replace its values.\n", use);
        return;
    }
    const auto found = std::ranges::find(library, name, &scene::LibraryEntry::name);
    if (found != library.end()) return print(*found);
    std::vector<std::string> names;
    for (const auto& entry : library) names.push_back(entry.name);
    const auto hint = scene::nearest(name, names);
    throw scene::InputError({fmt::format("{} '{}': unknown, allowed {}{}", kind, name, fmt::join(names, ", "),
                                         hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint))});
}

}  // namespace

void fabrics(const LibraryOptions& options) {
    const auto& library = scene::fabric_library();
    list(library, options.name, "fabric",
         fmt::format("fabrics: {{a: {{library: {}}}}}", library.front().name));
}

void projectiles(const LibraryOptions& options) {
    const auto& library = scene::projectile_library();
    list(library, options.name, "projectile",
         fmt::format("projectile: {{standard: {}, velocity: [0, 0, 400 m/s]}}", library.front().name));
}

}  // namespace weavefront::app
