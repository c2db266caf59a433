#include "restart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "weavefront/io/file_error.hpp"
#include "weavefront/scene/compare.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

// What a run has done does not depend on them.
constexpr std::array<std::string_view, 5> free_to_change{"time.end", "time.stop", "output.interval",
                                                         "output.history", "limits.energy_error"};

void require_same_past(const std::filesystem::path& path, const io::Checkpoint& checkpoint,
                       const scene::Scene& scene) {
    std::vector<std::string> messages;
    for (const auto& [key, before, now] : scene::differences(checkpoint.scene(), scene.resolved)) {
        if (std::ranges::find(free_to_change, key) != free_to_change.end()) continue;
        messages.push_back(fmt::format("--restart: {}: found {}, allowed is that of {}, {}", key,
                                       now.empty() ? "nothing" : now, path.string(),
                                       before.empty() ? "nothing" : before));
    }
    if (checkpoint.version() != WEAVEFRONT_VERSION)
        messages.push_back(
            fmt::format("--restart: {} was written by Weavefront {}, allowed is this version, {}",
                        path.string(), checkpoint.version(), WEAVEFRONT_VERSION));
    if (!messages.empty()) throw scene::InputError(messages);
}

}  // namespace

std::filesystem::path checkpoint_in(const std::filesystem::path& folder) { return folder / "checkpoint.h5"; }

Restart find_restart(const std::string& wanted, const std::filesystem::path& folder,
                     const scene::Scene& scene, const parallel::Communicator& comm) {
    const bool is_named = wanted != "auto";
    const auto newest = is_named ? std::filesystem::path(wanted) : checkpoint_in(folder);
    std::vector<std::filesystem::path> paths{newest};
    if (!is_named) paths.push_back(io::previous_checkpoint(newest));
    std::optional<io::Checkpoint> found;
    std::vector<std::string> passed_over;
    std::filesystem::path path;
    for (const auto& candidate : paths) {
        try {
            found.emplace(candidate, comm);
            path = candidate;
            break;
        } catch (const io::FileError& failure) {
            passed_over.emplace_back(failure.what());
        }
    }
    if (!found)
        throw scene::InputError(
            {fmt::format("--restart: no checkpoint can be used: {}", fmt::join(passed_over, "; "))});
    require_same_past(path, *found, scene);
    return {path, std::move(*found), std::move(passed_over)};
}

}  // namespace weavefront::app
