#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "weavefront/scene/nearest.hpp"

namespace weavefront::scene {
namespace {

constexpr std::int64_t most_plies = 10000;
constexpr std::string_view fabric_of_scene = "the name of a fabric of the scene";

// What the plies of a target have in common while they are read.
struct Stack {
    std::span<const Fabric> fabrics;
    std::vector<std::string> names;
    bool symmetric;

    Stack(std::span<const Fabric> of_scene, bool is_symmetric) : fabrics(of_scene), symmetric(is_symmetric) {
        for (const Fabric& fabric : fabrics) names.push_back(fabric.name);
    }
};

std::int32_t read_fabric_name(Section& section, const Stack& stack) {
    const std::string name = section.text("fabric", {}, fabric_of_scene);
    const auto found = std::ranges::find(stack.names, name);
    if (found != stack.names.end()) return static_cast<std::int32_t>(found - stack.names.begin());
    // Where no fabric could be read that is the fault, not the name.
    const bool wrong = section.has_text("fabric") && !stack.names.empty();
    section.refuse_if(wrong, "fabric", fabric_of_scene, nearest(name, stack.names));
    return -1;
}

Ply read_ply(Section& section, const Stack& stack) {
    Ply ply;
    ply.fabric = read_fabric_name(section, stack);
    ply.angle = section.quantity("angle", angle, any_value, 0);
    // A mirrored ply continues the modelled one only if its yarns run along and across the plane of symmetry.
    const double quarter_turns = ply.angle / (std::numbers::pi / 2);
    const bool askew = std::abs(quarter_turns - std::round(quarter_turns)) > 1e-9;
    section.refuse_if(stack.symmetric && askew, "angle",
                      "a multiple of 90 deg where the target has a symmetry");
    return ply;
}

// Distance of the mid-surfaces of a ply and the one before it.
double read_spacing(Section& section, const Stack& stack, std::int32_t fabric, std::int32_t before) {
    const auto thickness = [&](std::int32_t i) {
        return i < 0 ? 0 : stack.fabrics[static_cast<std::size_t>(i)].contact_thickness;
    };
    const double touching = (thickness(before) + thickness(fabric)) / 2;
    if (section.has("gap")) {
        section.refuse_if(section.has("spacing"), "gap", "none beside spacing");
        return touching + section.quantity("gap", length, non_negative);
    }
    const double spacing = section.quantity("spacing", length, positive, touching);
    const double rounding = 1e-12;
    section.refuse_if(spacing < touching * (1 - rounding), "spacing",
                      fmt::format("at least {}, the mean contact thickness of the two plies",
                                  at_least_text(touching, section.unit_of("spacing", length))));
    return spacing;
}

std::vector<Ply> read_equal_plies(Section& section, const Stack& stack) {
    const std::int64_t count = section.count("count", most_plies);
    const Ply first = read_ply(section, stack);
    const double spacing = read_spacing(section, stack, first.fabric, first.fabric);
    std::vector<Ply> plies(static_cast<std::size_t>(count), first);
    for (std::size_t i = 1; i < plies.size(); ++i) plies[i].spacing = spacing;
    return plies;
}

std::vector<Ply> read_listed_plies(Section& target, const Stack& stack) {
    std::optional<std::int32_t> before;
    target.require_at_most("plies", target.raw("plies")->value.items.size(), most_plies, "plies");
    return target.list("plies", [&](Section& section) {
        Ply ply = read_ply(section, stack);
        if (before) {
            ply.spacing = read_spacing(section, stack, ply.fabric, *before);
        } else {
            section.refuse_if(section.has("spacing"), "spacing", "none on the first ply");
            section.refuse_if(section.has("gap"), "gap", "none on the first ply");
        }
        before = ply.fabric;
        return ply;
    });
}

}  // namespace

std::vector<Ply> read_plies(Section& target, std::span<const Fabric> fabrics,
                            const std::array<bool, 2>& symmetry) {
    const Stack stack{fabrics, symmetry[0] || symmetry[1]};
    std::vector<Ply> plies;
    if (target.has_list("plies")) {
        plies = read_listed_plies(target, stack);
        target.refuse_if(plies.empty(), "plies", "at least one ply");
    } else {
        plies = target.required("plies", [&](Section& section) { return read_equal_plies(section, stack); });
    }
    for (std::size_t i = 1; i < plies.size(); ++i) plies[i].z = plies[i - 1].z + plies[i].spacing;
    return plies;
}

}  // namespace weavefront::scene
