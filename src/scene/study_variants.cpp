#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "hash.hpp"
#include "overrides.hpp"
#include "study_tests.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/study.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

/// The last key of a path, with its index where it is an item of a list.
std::string short_name(const std::string& axis) {
    std::size_t dot = axis.rfind('.');
    const bool item = dot != axis.npos && dot > 0 && dot + 1 < axis.size() && std::isdigit(static_cast<unsigned char>(axis[dot + 1])) != 0;
    if (item) dot = axis.rfind('.', dot - 1);
    return axis.substr(dot + 1);
}

/// `target.mesh.center`, `2 mm` to `center=2mm`: what every file system takes and no shell minds.
std::string folder_part(const std::string& axis, const std::string& label) {
    const auto kept = [](const std::string& name) {
        std::string text;
        for (const char c : name) {
            if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+') text += c;
            if (c == '/' || c == '_') text += '_';
            if (c == '%') text += "percent";
        }
        return text;
    };
    return kept(short_name(axis)) + "=" + kept(label);
}

std::string folder_of(const Study& study, const std::vector<std::string>& labels) {
    std::string name;
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        name += fmt::format("{}{}", i > 0 ? "," : "", folder_part(study.axes[i].name, labels[i]));
    return name;
}

/// Different labels may give the same name: `1 /mm` and `1/mm`. The later one gets a number.
void tell_apart(std::vector<Variant>& variants) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const auto before = variants.begin() + static_cast<std::ptrdiff_t>(i);
        const auto same = std::count_if(variants.begin(), before, [&](const Variant& other) { return other.name == variants[i].name; });
        if (same > 0) variants[i].name += fmt::format("#{}", same + 1);
    }
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
    if (compute == Compute::yarn) return fmt::format("yarn {} {} {}", tests.yarn.rate, tests.yarn.strain, tests.yarn.steps);
    if (compute == Compute::cell) {
        const std::string path = hash_of(read_text(tests.cell.path));
        return fmt::format("cell {} {} {}", path, tests.cell.refinement, tests.cell.crimp_tolerance);
    }
    return "";
}

}  // namespace

std::vector<Variant> variants_of(const Study& study) {
    std::vector<Variant> variants{{.name = "", .labels = {}, .values = {}, .settings = study.set}};
    for (const Axis& axis : study.axes) {
        std::vector<Variant> wider;
        for (const Variant& variant : variants) {
            for (const Choice& choice : axis.choices) {
                Variant next = variant;
                next.labels.push_back(choice.label);
                next.values.push_back(choice.value);
                next.settings.insert(next.settings.end(), choice.settings.begin(), choice.settings.end());
                wider.push_back(std::move(next));
            }
        }
        variants = std::move(wider);
    }
    for (Variant& variant : variants) variant.name = folder_of(study, variant.labels);
    tell_apart(variants);
    return variants;
}

Variant reference_of(const Study& study, const Variant& variant) {
    Variant reference = variant;
    const auto& changes = study.reference.settings;
    reference.settings.insert(reference.settings.end(), changes.begin(), changes.end());
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const auto given = std::ranges::find(changes, study.axes[i].name, &Setting::path);
        if (given == changes.end()) continue;
        reference.labels[i] = given->value;
        std::erase(reference.labels[i], '"');
        reference.values[i].reset();
    }
    reference.name = "reference," + folder_of(study, reference.labels);
    return reference;
}

Case parse_case(const Study& study, const std::string& scene_text, const Variant& variant) {
    std::vector<Setting> scene_settings, study_settings;
    for (const Setting& setting : variant.settings) (of_study(setting, study.compute) ? study_settings : scene_settings).push_back(setting);
    const Need need = study.compute == Compute::impact ? Need::impact : Need::fabrics;
    std::vector<std::string> messages;
    Case result;
    Tests tests;
    try {
        const auto change = [&](Value& root, Findings& findings) { apply_settings(root, scene_settings, findings); };
        result.scene = parse_changed_scene(scene_text, study.scene.string(), change, need);
    } catch (const InputError& error) {
        messages = error.messages();
    }
    try {
        tests = changed_tests(study, study_settings);
    } catch (const InputError& error) {
        messages.insert(messages.end(), error.messages().begin(), error.messages().end());
    }
    if (!messages.empty()) throw InputError(messages);
    result.yarn = tests.yarn;
    result.cell = tests.cell;
    result.hash = study.compute == Compute::impact ? result.scene.hash : hash_of(result.scene.resolved + text_of(tests, study.compute));
    return result;
}

std::vector<Case> parse_cases(const Study& study, const std::string& scene_text, const std::vector<Variant>& variants) {
    std::vector<Case> cases;
    std::vector<std::string> messages;
    for (const Variant& variant : variants) {
        try {
            cases.push_back(parse_case(study, scene_text, variant));
        } catch (const InputError& error) {
            for (const std::string& message : error.messages())
                if (std::ranges::find(messages, message) == messages.end()) messages.push_back(message);
        }
    }
    if (messages.empty()) messages = study.order_findings;
    if (!messages.empty()) throw InputError(messages);
    return cases;
}

}  // namespace weavefront::scene
