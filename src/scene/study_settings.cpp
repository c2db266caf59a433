#include "study_settings.hpp"

#include <fmt/format.h>
#include <yaml-cpp/emitter.h>

#include <algorithm>
#include <array>
#include <unordered_set>

#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

constexpr std::size_t most_axes = 100;

void emit(YAML::Emitter& emitter, const Value& value) {
    switch (value.kind) {
        case Value::Kind::null:
            emitter << YAML::Null;
            break;
        case Value::Kind::scalar:
            emitter << YAML::DoubleQuoted << value.text;
            break;
        case Value::Kind::list:
            emitter << YAML::Flow << YAML::BeginSeq;
            for (const Value& item : value.items) emit(emitter, item);
            emitter << YAML::EndSeq;
            break;
        case Value::Kind::map:
            emitter << YAML::Flow << YAML::BeginMap;
            for (const Entry& entry : value.entries) {
                emitter << YAML::Key << YAML::DoubleQuoted << entry.key << YAML::Value;
                emit(emitter, entry.value);
            }
            emitter << YAML::EndMap;
    }
}

const char* separator(const std::string& text) { return text.empty() ? "" : " "; }

/// A value in a few characters, for tables and names of folders.
std::string label_of(const Value& value) {
    if (value.kind == Value::Kind::null) return "none";
    if (value.kind == Value::Kind::scalar) return value.text;
    std::string text;
    for (const Value& item : value.items) text += fmt::format("{}{}", separator(text), label_of(item));
    for (const Entry& entry : value.entries)
        text += fmt::format("{}{} {}", separator(text), entry.key, label_of(entry.value));
    return text;
}

std::optional<double> si_value(const Value& value, const Units& units) {
    static constexpr std::array dimensions{ratio,   length,    duration,      speed,   angle,
                                           rate,    mass,      area,          density, areal_density,
                                           modulus, viscosity, area_stiffness};
    if (value.kind != Value::Kind::scalar) return std::nullopt;
    for (const Dimension& dimension : dimensions) {
        const Quantity quantity = units.read(value.text, dimension);
        if (quantity.problem.empty()) return quantity.value;
    }
    return std::nullopt;
}

Axis read_axis(const Entry& entry, const std::string& path, Context& context) {
    Axis axis{.name = entry.key, .choices = {}};
    for (const Value& item : entry.value.items) {
        const std::string value = item.kind == Value::Kind::null ? "" : flow_text(item);
        axis.choices.push_back(
            {label_of(item), si_value(item, context.units), {{entry.key, value, item.where.text}}});
    }
    for (const Entry& named : entry.value.entries)
        axis.choices.push_back(
            {named.key, std::nullopt, read_settings(named.value, path + "." + named.key, context)});
    if (axis.choices.empty())
        context.findings.add(entry.value.where, path, describe(entry.value),
                             "a list of values, or a map of names to maps of paths and values");
    std::unordered_set<std::string_view> labels;
    for (const Choice& choice : axis.choices)
        if (!labels.insert(choice.label).second)
            context.findings.add(entry.value.where, path, fmt::format("'{}' again", printable(choice.label)),
                                 "each value once");
    return axis;
}

}  // namespace

std::string flow_text(const Value& value) {
    YAML::Emitter emitter;
    emit(emitter, value);
    return emitter.c_str();
}

std::vector<Setting> read_settings(const Value& map, const std::string& path, Context& context) {
    std::vector<Setting> settings;
    if (map.kind != Value::Kind::map)
        context.findings.add(map.where, path, describe(map),
                             "a map of paths and values, such as {time.end: 80 us}");
    std::unordered_set<std::string_view> keys;
    for (const Entry& entry : map.entries) {
        if (!keys.insert(entry.key).second)
            context.findings.add(entry.where, path + "." + entry.key, "the key again", "once");
        settings.push_back({entry.key, entry.value.kind == Value::Kind::null ? "" : flow_text(entry.value),
                            entry.value.where.text});
    }
    return settings;
}

std::vector<Axis> read_axes(const Value& list, Context& context) {
    std::vector<Axis> axes;
    constexpr std::string_view allowed = "a list of axes, such as - {target.mesh.center: [2 mm, 1 mm]}";
    if (list.kind != Value::Kind::list || list.items.empty())
        context.findings.add(list.where, "variants", describe(list), allowed);
    if (list.items.size() > most_axes) {
        context.findings.add(list.where, "variants", fmt::format("{} axes", list.items.size()),
                             fmt::format("at most {}", most_axes));
        context.findings.raise();
    }
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const Value& item = list.items[i];
        const std::string path = fmt::format("variants.{}", i);
        if (item.kind != Value::Kind::map || item.entries.size() != 1) {
            context.findings.add(item.where, path, describe(item),
                                 "a map of one key, a path or the name of an axis");
            continue;
        }
        const Entry& entry = item.entries.front();
        if (std::ranges::find(axes, entry.key, &Axis::name) != axes.end())
            context.findings.add(entry.where, path, fmt::format("the axis '{}' again", entry.key),
                                 "each axis once");
        axes.push_back(read_axis(entry, path + "." + entry.key, context));
    }
    return axes;
}

}  // namespace weavefront::scene
