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

double weight_of_yarns(const scene::Fabric& fabric) {
    return 2 * fabric.yarn.area * fabric.density / fabric.yarn.span;
}

}  // namespace

bool has_plausible_weight(const scene::Fabric& fabric) {
    const double ratio = fabric.areal_density / weight_of_yarns(fabric);
    return std::max(ratio, 1 / ratio) <= most_apart;
}

void warn_of_weave(const Shot& shot, const scene::Fabric& fabric, Phrases& found) {
    const auto& yarn = fabric.yarn;
    const auto& units = shot.scene.units;
    const auto length = [&](double value) { return text_of(value, units.length); };
    if (!has_plausible_weight(fabric))
        found.push_back(fmt::format(
            "fabric {}: yarns of {} every {} in two directions weigh {} at {}, but the areal density is {}",
            fabric.name, text_of(yarn.area, units.area), length(yarn.span),
            text_of(weight_of_yarns(fabric), units.areal_density), text_of(fabric.density, units.density),
            text_of(fabric.areal_density, units.areal_density)));
    if (fabric.thickness > yarn.span)
        found.push_back(fmt::format("fabric {}: its yarns rise and fall by {} every {}", fabric.name,
                                    length(fabric.thickness), length(yarn.span)));
    else if (fabric.crimp() > scene::most_crimp)
        found.push_back(
            fmt::format("fabric {}: with a thickness of {} yarns are {:.2g} % longer than the cell, plain "
                        "weaves have 1 to 4 %: "
                        "this thickness is more than that of the fabric, and stands for other slack, too",
                        fabric.name, length(fabric.thickness), 100 * fabric.crimp()));
    const double height = yarn.area / yarn.width;
    // A round yarn is pi/4 of its width high in the mean; in a fabric yarns lie flat.
    if (height > yarn.width)
        found.push_back(fmt::format("fabric {}: yarns of {} that are {} wide would be {} high", fabric.name,
                                    text_of(yarn.area, units.area), length(yarn.width), length(height)));
    else if (fabric.thickness > 0 && fabric.thickness / 2 < least_of_height * height)
        found.push_back(
            fmt::format("fabric {}: a thickness of {} lets yarns cross that are {} high (area over width)",
                        fabric.name, length(fabric.thickness), length(height)));
    if (fabric.contact_thickness > most_spans * yarn.span)
        found.push_back(fmt::format(
            "fabric {}: plies touch at a distance of {} (contact_thickness), more than two spans of {}",
            fabric.name, length(fabric.contact_thickness), length(yarn.span)));
}

}  // namespace weavefront::app
