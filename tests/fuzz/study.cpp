/// A study file, and below a line `=== scene` the scene that it varies.

#include "weavefront/scene/study.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>

#include "require.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::fuzz {
namespace {

// Reading thousands of variants shows no more than reading a few.
constexpr std::size_t most_variants = 12;

const std::string name = "study.yaml", scene_name = "scene.yaml";

scene::Vocabulary vocabulary(scene::Compute) {
    return {{"outcome", "energy_error"}, {"column", "stress"}, {"displacement"}, {"smith", "constant_rate"}};
}

std::pair<std::string, std::string> split(const std::string& input) {
    constexpr std::string_view separator = "\n=== scene\n";
    const auto at = input.find(separator);
    if (at == input.npos) return {input, {}};
    return {input.substr(0, at + 1), input.substr(at + separator.size())};
}

void read_cases(scene::Study study, const std::string& scene_text) {
    study.scene = scene_name;
    std::size_t count = 1;
    for (const auto& axis : study.axes) count *= axis.choices.size();
    if (count > most_variants) return;
    const auto variants = variants_of(study);
    std::unordered_set<std::string> folders;
    for (const auto& variant : variants) {
        require(folders.insert(variant.name).second, "variants have folders of their own", variant.name);
        require(variant.name.size() < 255 && variant.name.find('/') == variant.name.npos,
                "folders can be made", variant.name);
    }
    const auto cases = parse_cases(study, scene_text, variants);
    require(cases.size() == variants.size(), "each variant is a case");
    if (study.reference.kind == scene::Reference::Kind::variant)
        parse_case(study, scene_text, reference_of(study, variants.front()));
}

}  // namespace
}  // namespace weavefront::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace weavefront;
    const auto [text, scene_text] = fuzz::split({reinterpret_cast<const char*>(data), size});
    try {
        scene::require_text(text, fuzz::name);
        scene::require_text(scene_text, fuzz::scene_name);
        fuzz::read_cases(scene::parse_study(text, fuzz::name, fuzz::vocabulary), scene_text);
    } catch (const scene::InputError& refusal) {
        fuzz::require_messages(refusal);
    }
    return 0;
}
