#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "parts.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

// Data sheets state count, linear density and areal density to some per cent, finish and moisture included.
constexpr double most_apart = 0.1;

/// Mass of a yarn per length, kg/m, as data sheets give it: denier is g per 9000 m, dtex g per 10 000 m.
std::optional<double> read_linear_density(Section& section) {
    constexpr std::array<std::pair<std::string_view, double>, 2> lengths{{{"denier", 9000}, {"dtex", 10000}}};
    std::optional<double> found;
    for (const auto& [key, length_of_gram] : lengths) {
        if (!section.has(key)) continue;
        section.refuse_if(found.has_value(), key, "none beside denier");
        found = section.quantity(key, ratio, positive) * 1e-3 / length_of_gram;
    }
    return found;
}

struct DataSheetYarn {
    Yarn yarn;
    std::optional<double> linear_density = {};  ///< kg/m
    bool has_width = true;
};

DataSheetYarn read_yarn(Section& section, double density, std::optional<double> span) {
    DataSheetYarn read;
    auto& yarn = read.yarn;
    if (span) section.refuse_if(section.has("span"), "span", "none beside count, which gives the span");
    yarn.span = span ? *span : section.quantity("span", length, positive);
    read.linear_density = read_linear_density(section);
    if (read.linear_density) {
        section.refuse_if(section.has("area"), "area", "none beside denier or dtex, which give the area");
        yarn.area = *read.linear_density / density;
    } else {
        yarn.area = section.quantity("area", area, positive);
    }
    read.has_width = section.has("width") || !read.linear_density;
    if (!read.has_width) return read;
    yarn.width = section.quantity("width", length, positive);
    section.refuse_if(
        yarn.width >= yarn.span, "width",
        fmt::format("less than the span, {}", text_of(yarn.span, section.unit_of("width", length), 6)));
    return read;
}

/// Width of a yarn without voids, an ellipse of half the height of the fabric.
double width_of_ellipse(const Fabric& fabric) {
    return fabric.yarn.area / (std::numbers::pi / 4 * fabric.thickness / 2);
}

}  // namespace

void read_weave(Section& section, Fabric& fabric) {
    std::optional<double> span;
    if (section.has("count")) span = 1 / section.quantity("count", per_length, positive);
    const auto read =
        section.required("yarn", [&](Section& yarn) { return read_yarn(yarn, fabric.density, span); });
    fabric.yarn = read.yarn;
    fabric.thickness = section.quantity("thickness", length, non_negative);
    if (!read.has_width) {
        fabric.yarn.width = width_of_ellipse(fabric);
        if (fabric.yarn.width >= fabric.yarn.span)
            section.refuse("yarn", "no width",
                           "a width: an ellipse of the yarn's area and half the thickness does not fit");
    }
    std::optional<double> expected;
    if (read.linear_density) {
        const double crimp = fabric.crimp() <= most_crimp ? fabric.crimp() : 0;
        expected = 2 * *read.linear_density / fabric.yarn.span * (1 + crimp);
    }
    fabric.areal_density = section.quantity("areal_density", areal_density, positive, expected);
    if (expected)
        section.refuse_if(
            std::abs(fabric.areal_density / *expected - 1) > most_apart, "areal_density",
            fmt::format("within 10 % of {}, which count and linear density give",
                        text_of(*expected, section.unit_of("areal_density", areal_density), 4)));
}

}  // namespace weavefront::scene
