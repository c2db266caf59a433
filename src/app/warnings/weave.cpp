#include <fmt/format.h>

#include <algorithm>

#include "warnings/subjects.hpp"

namespace weavefront::app {

namespace {

// Crimp makes yarns longer than the cell and coatings add mass; beyond this factor a number or a unit is
// wrong.
constexpr double most_apart = 1.3;

// The axes of the yarns lie t/2 apart at a crossover, about the height of a yarn. Slack yarns and cells that
// stand for slip in the clamps (IT04: four times the height) rise more; a tenth of it is no weave of such
// yarns.
constexpr double least_of_height = 0.1;

// A ply of a plain weave is two yarns high, each at most as wide as the span.
constexpr double most_spans = 2;

void warn_of_yarns(const Shot& shot, const NamedYarns& yarns, double thickness, Phrases& found) {
    const auto& units = shot.scene.units;
    const auto& yarn = yarns.system.yarn;
    const auto length = [&](double value) { return text_of(value, units.length); };
    const double rise = 4 * yarns.system.crimp_height;
    if (rise > yarn.span)
        found.push_back(fmt::format("{}: its yarns rise and fall by {} every {}", yarns.name, length(rise),
                                    length(yarn.span)));
    else if (yarns.system.crimp() > scene::most_crimp)
        found.push_back(
            fmt::format("{}: with a thickness of {} yarns are {:.2g} % longer than the cell, plain "
                        "weaves have 1 to 4 %: "
                        "this thickness is more than that of the fabric, and stands for other slack, too",
                        yarns.name, length(thickness), 100 * yarns.system.crimp()));
    const double height = yarn.area / yarn.width;
    // A round yarn is pi/4 of its width high in the mean; in a fabric yarns lie flat.
    if (height > yarn.width)
        found.push_back(fmt::format("{}: yarns of {} that are {} wide would be {} high", yarns.name,
                                    text_of(yarn.area, units.area), length(yarn.width), length(height)));
    else if (thickness > 0 && thickness / 2 < least_of_height * height)
        found.push_back(
            fmt::format("{}: a thickness of {} lets yarns cross that are {} high (area over width)",
                        yarns.name, length(thickness), length(height)));
}

/// How the yarns lie, as a message says it.
std::string layout(const Shot& shot, const scene::Fabric& fabric) {
    const auto& units = shot.scene.units;
    const auto of = [&](const scene::YarnSystem& system) {
        return fmt::format("{} every {}", text_of(system.yarn.area, units.area),
                           text_of(system.spacing, units.length));
    };
    const auto [fill, warp] = fabric.systems();
    if (!fabric.warp) return fmt::format("yarns of {} in two directions", of(fill));
    return fmt::format("fill yarns of {} and warp yarns of {}", of(fill), of(warp));
}

}  // namespace

std::vector<NamedYarns> named_yarns(const scene::Fabric& fabric) {
    if (!fabric.warp) return {{"fabric " + fabric.name, fabric.fill_system()}};
    return {{fmt::format("fabric {}, fill", fabric.name), fabric.fill_system()},
            {fmt::format("fabric {}, warp", fabric.name), fabric.warp_system()}};
}

bool has_plausible_weight(const scene::Fabric& fabric) {
    const double ratio = fabric.areal_density / fabric.weight_of_yarns();
    return std::max(ratio, 1 / ratio) <= most_apart;
}

void warn_of_weave(const Shot& shot, const scene::Fabric& fabric, Phrases& found) {
    const auto& units = shot.scene.units;
    const auto length = [&](double value) { return text_of(value, units.length); };
    if (!has_plausible_weight(fabric))
        found.push_back(fmt::format(
            "fabric {}: {} weigh {} at {}, but the areal density is {}", fabric.name, layout(shot, fabric),
            text_of(fabric.weight_of_yarns(), units.areal_density), text_of(fabric.density, units.density),
            text_of(fabric.areal_density, units.areal_density)));
    for (const auto& yarns : named_yarns(fabric)) warn_of_yarns(shot, yarns, fabric.thickness, found);
    const auto [fill, warp] = fabric.systems();
    const double span = std::max(fill.yarn.span, warp.yarn.span);
    if (fabric.contact_thickness > most_spans * span)
        found.push_back(fmt::format(
            "fabric {}: plies touch at a distance of {} (contact_thickness), more than two spans of {}",
            fabric.name, length(fabric.contact_thickness), length(span)));
}

}  // namespace weavefront::app
