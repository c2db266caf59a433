#include "study_reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "study_settings.hpp"
#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

constexpr std::array<std::string_view, 10> scene_keys{"title",       "fabrics", "target",  "projectile",
                                                      "projectiles", "contact", "damping", "time",
                                                      "limits",      "output"};
constexpr std::string_view path_name = "reference.variant";

std::vector<std::string> labels_of(const Axis& axis) {
    std::vector<std::string> labels;
    for (const Choice& choice : axis.choices) labels.push_back(choice.label);
    return labels;
}

std::vector<std::string> names_of(const std::vector<Axis>& axes) {
    std::vector<std::string> names;
    for (const Axis& axis : axes) names.push_back(axis.name);
    return names;
}

/// The place of a text in a list.
std::optional<std::size_t> index_in(const std::vector<std::string>& all, const std::string& one) {
    const auto found = std::ranges::find(all, one);
    return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

/// A label that one axis alone has.
bool choose_by_label(const std::string& label, const std::vector<Axis>& axes, Reference& reference) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t a = 0; a < axes.size(); ++a)
        if (const auto choice = index_in(labels_of(axes[a]), label)) found.emplace_back(a, *choice);
    if (found.size() != 1) return false;
    reference.choices[found.front().first] = found.front().second;
    return true;
}

void choose_by_name(const Value& value, const Study& study, Context& context, Reference& reference) {
    if (choose_by_label(value.text, study.axes, reference)) return;
    const std::vector<Variant> variants = variants_of(study);
    const auto named = std::ranges::find(variants, value.text, &Variant::name);
    if (named != variants.end()) {
        for (std::size_t a = 0; a < study.axes.size(); ++a) reference.choices[a] = named->choices[a];
        return;
    }
    std::vector<std::string> labels;
    for (const Axis& axis : study.axes) std::ranges::move(labels_of(axis), std::back_inserter(labels));
    context.findings.add(value.where, path_name, describe(value),
                         fmt::format("a label that one axis alone has ({}), the name of a variant, such as "
                                     "'{}', or a map, such as {{time.end: 80 us}}",
                                     fmt::join(labels, ", "), variants.empty() ? "" : variants.front().name),
                         nearest(value.text, labels));
}

/// Whether the values of an axis are named settings, which only their label can stand for.
bool has_labels(const Axis& axis) {
    return std::ranges::any_of(axis.choices, [&](const Choice& choice) {
        return choice.settings.size() != 1 || choice.settings.front().path != axis.name;
    });
}

void choose_label(const Value& value, std::size_t a, const Axis& axis, Context& context,
                  Reference& reference) {
    const std::vector<std::string> labels = labels_of(axis);
    reference.choices[a] = value.kind == Value::Kind::scalar ? index_in(labels, value.text) : std::nullopt;
    if (!reference.choices[a])
        context.findings.add(value.where, fmt::format("{}.{}", path_name, printable(axis.name)),
                             describe(value), fmt::format("one of {}", fmt::join(labels, ", ")),
                             nearest(value.text, labels));
}

}  // namespace

void read_reference_variant(const Value& value, const Study& study, Context& context, Reference& reference) {
    reference.choices.assign(study.axes.size(), std::nullopt);
    if (value.kind == Value::Kind::scalar && !value.text.empty() && !study.axes.empty())
        return choose_by_name(value, study, context, reference);
    const std::vector<std::string> axes = names_of(study.axes);
    Value paths = value;
    paths.entries.clear();
    for (const Entry& entry : value.entries) {
        const auto axis = index_in(axes, entry.key);
        const bool is_path = entry.key.find('.') != entry.key.npos ||
                             std::ranges::find(scene_keys, entry.key) != scene_keys.end();
        if (axis && has_labels(study.axes[*axis]))
            choose_label(entry.value, *axis, study.axes[*axis], context, reference);
        else if (axis || is_path)
            paths.entries.push_back(entry);
        else
            context.findings.add(
                entry.where, path_name, fmt::format("'{}'", printable(entry.key)),
                fmt::format("an axis ({}) or a path of the scene, such as target.mesh.center",
                            fmt::join(axes, ", ")),
                nearest(entry.key, axes));
    }
    reference.settings = read_settings(paths, std::string(path_name), context);
}

}  // namespace weavefront::scene
