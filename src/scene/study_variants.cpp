#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <unordered_map>
#include <unordered_set>

#include "hash.hpp"
#include "overrides.hpp"
#include "study_tests.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/study.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

// Thousands of variants may all have thousands of faults.
constexpr std::size_t enough_messages = 1000;

/// The last key of a path, with its index where it is an item of a list.
std::string short_name(const std::string& axis) {
    std::size_t dot = axis.rfind('.');
    const bool item = dot != axis.npos && dot > 0 && dot + 1 < axis.size() &&
                      std::isdigit(static_cast<unsigned char>(axis[dot + 1])) != 0;
    if (item) dot = axis.rfind('.', dot - 1);
    return axis.substr(dot + 1);
}

/// `target.mesh.center`, `2 mm` to `center=2mm`: what every file system takes and no shell minds.
std::string folder_part(const std::string& axis, const std::string& label) {
    const auto kept = [](const std::string& name) {
        std::string text;
        for (const char c : name) {
            if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+')
                text += c;
            if (c == '/' || c == '_') text += '_';
            if (c == '%') text += "percent";
        }
        return text;
    };
    return kept(short_name(axis)) + "=" + kept(label);
}

/// Names longer than file systems take (255 bytes) are cut; a hash of all of it tells them apart.
std::string of_bounded_length(const std::string& name) {
    constexpr std::size_t most = 200;
    return name.size() <= most ? name : name.substr(0, most - 17) + "~" + hash_of(name);
}

std::string folder_of(const Study& study, const std::vector<std::string>& labels,
                      const std::string& start = {}) {
    std::string name = start;
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        name += fmt::format("{}{}", i > 0 ? "," : "", folder_part(study.axes[i].name, labels[i]));
    return of_bounded_length(name);
}

/// Different labels may give the same name: `1 /mm` and `1/mm`. The later one gets a number.
void tell_apart(std::vector<Variant>& variants) {
    std::unordered_map<std::string, int> given;
    for (Variant& variant : variants)
        if (const int same = ++given[variant.name]; same > 1) variant.name += fmt::format("#{}", same);
}

bool of_study(const Setting& setting, Compute compute) {
    return (compute == Compute::yarn && setting.path.starts_with("yarn.")) ||
           (compute == Compute::cell && setting.path.starts_with("cell."));
}

Tests changed_tests(const Study& study, const std::vector<Setting>& settings) {
    if (study.compute == Compute::impact) return {};
    Value document = parse_document(study.text, [&](int line, int column) {
        return Location{fmt::format("{}:{}:{}", study.name, line, column), line, column};
    });
    Context context;
    apply_settings(document, settings, context.findings);
    Section root(document, {study.name + ":1:1"}, "", context);
    const Tests tests = read_tests(root, study.compute, std::filesystem::path(study.name).parent_path());
    context.findings.raise();
    return tests;
}

std::string text_of(const Tests& tests, Compute compute) {
    if (compute == Compute::yarn)
        return fmt::format("yarn {} {} {}", tests.yarn.rate, tests.yarn.strain, tests.yarn.steps);
    if (compute == Compute::cell) {
        const std::string path = hash_of(read_text(tests.cell.path, most_of_table));
        return fmt::format("cell {} {} {}", path, tests.cell.refinement, tests.cell.crimp_tolerance);
    }
    return "";
}

/// Adds the choice of one more axis.
void choose(Variant& variant, const Axis& axis, std::size_t index) {
    const Choice& choice = axis.choices[index];
    variant.labels.push_back(choice.label);
    variant.values.push_back(choice.value);
    variant.choices.push_back(index);
    variant.settings.insert(variant.settings.end(), choice.settings.begin(), choice.settings.end());
}

}  // namespace

std::vector<Variant> variants_of(const Study& study) {
    std::vector<Variant> variants{
        {.name = "", .labels = {}, .values = {}, .choices = {}, .settings = study.set}};
    for (const Axis& axis : study.axes) {
        std::vector<Variant> wider;
        for (const Variant& variant : variants)
            for (std::size_t c = 0; c < axis.choices.size(); ++c) {
                wider.push_back(variant);
                choose(wider.back(), axis, c);
            }
        variants = std::move(wider);
    }
    for (Variant& variant : variants) variant.name = folder_of(study, variant.labels);
    tell_apart(variants);
    return variants;
}

Variant reference_of(const Study& study, const Variant& variant) {
    Variant reference{.name = "", .labels = {}, .values = {}, .choices = {}, .settings = study.set};
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        choose(reference, study.axes[i], study.reference.choices[i].value_or(variant.choices[i]));
    const auto& changes = study.reference.settings;
    reference.settings.insert(reference.settings.end(), changes.begin(), changes.end());
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const auto given = std::ranges::find(changes, study.axes[i].name, &Setting::path);
        if (given == changes.end()) continue;
        reference.labels[i] = given->value;
        std::erase(reference.labels[i], '"');
        reference.values[i].reset();
    }
    reference.name = folder_of(study, reference.labels, "reference,");
    return reference;
}

Case parse_case(const Study& study, const std::string& scene_text, const Variant& variant) {
    std::vector<Setting> scene_settings, study_settings;
    for (const Setting& setting : variant.settings)
        (of_study(setting, study.compute) ? study_settings : scene_settings).push_back(setting);
    const Need need = study.compute == Compute::impact ? Need::impact : Need::fabrics;
    std::vector<std::string> messages;
    std::size_t more = 0;
    const auto take = [&](const InputError& error) {
        messages.insert(messages.end(), error.messages().begin(), error.messages().end());
        more += error.more();
    };
    Case result;
    Tests tests;
    try {
        const auto change = [&](Value& root, Findings& findings) {
            apply_settings(root, scene_settings, findings);
        };
        result.scene = parse_changed_scene(scene_text, study.scene.string(), change, need);
    } catch (const InputError& error) {
        take(error);
    }
    try {
        tests = changed_tests(study, study_settings);
    } catch (const InputError& error) {
        take(error);
    }
    if (!messages.empty()) throw InputError(messages, more);
    result.yarn = tests.yarn;
    result.cell = tests.cell;
    result.hash = study.compute == Compute::impact
                      ? result.scene.hash
                      : hash_of(result.scene.resolved + text_of(tests, study.compute));
    return result;
}

std::vector<Case> parse_cases(const Study& study, const std::string& scene_text,
                              const std::vector<Variant>& variants) {
    std::vector<Case> cases;
    std::vector<std::string> messages;
    std::unordered_set<std::string> known;
    std::size_t more = 0;
    for (const Variant& variant : variants) {
        try {
            cases.push_back(parse_case(study, scene_text, variant));
        } catch (const InputError& error) {
            more = std::max(more, error.more());
            for (const std::string& message : error.messages())
                if (known.insert(message).second) messages.push_back(message);
            if (messages.size() >= enough_messages) break;
        }
    }
    if (messages.empty()) messages = study.order_findings;
    if (!messages.empty()) throw InputError(messages, more);
    return cases;
}

}  // namespace weavefront::scene
