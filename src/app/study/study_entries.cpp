#include "study_entries.hpp"

#include <algorithm>

namespace weavefront::app {

std::vector<StudyEntry> study_entries(const scene::Study& study, const std::string& scene_text) {
    const std::vector<scene::Variant> variants = scene::variants_of(study);
    const bool compared = study.reference.kind == scene::Reference::Kind::variant;
    std::vector<scene::Variant> all = variants;
    if (compared)
        for (const scene::Variant& variant : variants) all.push_back(scene::reference_of(study, variant));
    const std::vector<scene::Case> cases = scene::parse_cases(study, scene_text, all);

    std::vector<StudyEntry> entries;
    for (std::size_t i = 0; i < variants.size(); ++i) entries.push_back({variants[i], cases[i], false, i});
    if (!compared) return entries;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const scene::Case& wanted = cases[variants.size() + i];
        const auto found = std::ranges::find_if(
            entries, [&](const StudyEntry& entry) { return entry.input.hash == wanted.hash; });
        entries[i].reference = static_cast<std::size_t>(found - entries.begin());
        if (found == entries.end())
            entries.push_back({all[variants.size() + i], wanted, true, entries.size()});
    }
    return entries;
}

}  // namespace weavefront::app
