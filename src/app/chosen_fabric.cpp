#include "chosen_fabric.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

scene::Fabric chosen_fabric(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                            const std::string& name) {
    const scene::Scene scene = scene::read_scene(path, overrides, scene::Need::fabrics);
    std::vector<std::string> names;
    for (const scene::Fabric& fabric : scene.fabrics) names.push_back(fabric.name);
    if (name.empty()) {
        if (scene.fabrics.size() == 1) return scene.fabrics.front();
        throw scene::InputError({fmt::format("--fabric: found nothing, allowed one of {}, the fabrics of {}",
                                             fmt::join(names, ", "), path.string())});
    }
    const auto found = std::ranges::find(scene.fabrics, name, &scene::Fabric::name);
    if (found != scene.fabrics.end()) return *found;
    const std::string hint = scene::nearest(name, names);
    const std::string question = hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint);
    throw scene::InputError({fmt::format("--fabric: found '{}', allowed one of {}{}", scene::printable(name),
                                         fmt::join(names, ", "), question)});
}

}  // namespace weavefront::app
