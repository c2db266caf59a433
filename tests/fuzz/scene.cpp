/// A scene file, and below a line `--set` the overrides, one a line.

#include <cstddef>
#include <cstdint>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "require.hpp"
#include "scratch_file.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::fuzz {
namespace {

/// Text before and lines after the line `--set`.
std::pair<std::string, std::vector<std::string>> split(const std::string& input) {
    constexpr std::string_view separator = "\n--set\n";
    const auto at = input.find(separator);
    std::vector<std::string> overrides;
    if (at == input.npos) return {input, overrides};
    std::istringstream lines(input.substr(at + separator.size()));
    for (std::string line; std::getline(lines, line);) overrides.push_back(line);
    return {input.substr(0, at + 1), overrides};
}

/// A scene that was read can be read again from its resolved text, and is the same.
void require_same_again(const scene::Scene& read) {
    try {
        const auto again = scene::parse_scene(read.resolved, "resolved");
        require(again.hash == read.hash && again.resolved == read.resolved,
                "a resolved scene is the same again", read.resolved);
    } catch (const scene::InputError& refusal) {
        require(false, refusal.what(), read.resolved);
    }
}

void read(const std::string& text, const std::vector<std::string>& overrides, scene::Need need) {
    const ScratchFile file(std::as_bytes(std::span(text)));
    try {
        const auto scene = scene::read_scene(file.path(), overrides, need);
        if (need == scene::Need::impact) require_same_again(scene);
    } catch (const scene::InputError& refusal) {
        require_messages(refusal);
    }
}

}  // namespace
}  // namespace weavefront::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace weavefront;
    const auto [text, overrides] = fuzz::split({reinterpret_cast<const char*>(data), size});
    fuzz::read(text, overrides, scene::Need::impact);
    if (text.find("target") == text.npos) fuzz::read(text, overrides, scene::Need::fabrics);
    return 0;
}
