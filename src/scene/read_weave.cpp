#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "both.hpp"
#include "parts.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

// Data sheets state count, linear density and areal density to some per cent, finish and moisture included.
constexpr double most_apart = 0.1;

constexpr Range take_up{0, true, 1, " of 0 to 100 %", "'0.02' or '2 %'"};

/// Mass of the yarns per length, kg/m, as data sheets give it: denier is g per 9000 m, dtex g per 10 000 m.
std::optional<Both> read_linear_density(Section& section) {
    constexpr std::array<std::pair<std::string_view, double>, 2> lengths{{{"denier", 9000}, {"dtex", 10000}}};
    std::optional<Both> found;
    for (const auto& [key, length_of_gram] : lengths) {
        if (!section.has(key)) continue;
        section.refuse_if(found.has_value(), key, "none beside denier");
        const Both grams = both(section, key, ratio, positive);
        found = {grams.fill * 1e-3 / length_of_gram, grams.warp * 1e-3 / length_of_gram};
    }
    return found;
}

struct DataSheetYarns {
    Both span, area, width;
    std::optional<Both> linear_density = {};  ///< kg/m
    bool has_width = true;
};

/// @param count yarns of fill and warp per length, 1/m
DataSheetYarns read_yarns(Section& section, double density, const std::optional<Both>& count) {
    DataSheetYarns read;
    if (count) section.refuse_if(section.has("span"), "span", "none beside count, which gives the span");
    // A yarn crosses those of the other direction.
    read.span = count ? Both{1 / count->warp, 1 / count->fill} : both(section, "span", length, positive);
    read.linear_density = read_linear_density(section);
    if (read.linear_density) {
        section.refuse_if(section.has("area"), "area", "none beside denier or dtex, which give the area");
        read.area = {read.linear_density->fill / density, read.linear_density->warp / density};
    } else {
        read.area = both(section, "area", area, positive);
    }
    read.has_width = section.has("width") || !read.linear_density;
    if (!read.has_width) return read;
    read.width = both(section, "width", length, positive);
    const auto unit = section.unit_of("width", length);
    if (read.span.fill == read.span.warp)
        section.refuse_if(read.width.most() >= read.span.fill, "width",
                          fmt::format("less than the span, {}", text_of(read.span.fill, unit, 6)));
    else
        section.refuse_if(read.width.fill >= read.span.warp || read.width.warp >= read.span.fill, "width",
                          fmt::format("less than the distance of the yarns, {} of fill and {} of warp",
                                      text_of(read.span.warp, unit, 6), text_of(read.span.fill, unit, 6)));
    return read;
}

/// Height of a crossover at rest, from the length of a yarn over that of the cell less 1, and the reverse of
/// YarnSystem::crimp.
double crimp_height(double span, double crimp) { return span / 2 * std::sqrt((1 + crimp) * (1 + crimp) - 1); }

/// Heights of the crossover over the ends of the bars (34), m: from the measured crimps, as they
/// are, or from the thickness in equal parts.
Both read_crimp_heights(Section& section, const Both& span) {
    if (section.has("crimp_height")) {
        for (const std::string_view key : {"thickness", "crimp"})
            section.refuse_if(section.has(key), key, "none beside crimp_height");
        return both(section, "crimp_height", length, non_negative);
    }
    if (section.has("crimp")) {
        section.refuse_if(section.has("thickness"), "thickness", "none beside crimp, which gives it");
        const Both crimp = both(section, "crimp", ratio, take_up);
        return {crimp_height(span.fill, crimp.fill), crimp_height(span.warp, crimp.warp)};
    }
    const double quarter = section.quantity("thickness", length, non_negative) / 4;
    return {quarter, quarter};
}

/// Width of a yarn without voids, an ellipse of half the height of the fabric.
double width_of_ellipse(double area, double thickness) {
    return area / (std::numbers::pi / 4 * thickness / 2);
}

/// Mass per area of yarns with their crimp, kg/m2.
double weight_of(const Fabric& fabric, const Both& linear_density) {
    const auto of_system = [&](const YarnSystem& system, double density) {
        const double crimp = fabric.crimp() <= most_crimp ? system.crimp() : 0;
        return density / system.spacing * (1 + crimp);
    };
    return of_system(fabric.fill_system(), linear_density.fill) +
           of_system(fabric.warp_system(), linear_density.warp);
}

}  // namespace

void read_weave(Section& section, Fabric& fabric) {
    std::optional<Both> count;
    if (section.has("count")) count = both(section, "count", per_length, positive);
    auto read =
        section.required("yarn", [&](Section& yarn) { return read_yarns(yarn, fabric.density, count); });
    const Both height = read_crimp_heights(section, read.span);
    fabric.thickness = 2 * (height.fill + height.warp);
    if (!read.has_width) {
        read.width = {width_of_ellipse(read.area.fill, fabric.thickness),
                      width_of_ellipse(read.area.warp, fabric.thickness)};
        if (read.width.fill >= read.span.warp || read.width.warp >= read.span.fill)
            section.refuse("yarn", "no width",
                           "a width: an ellipse of the yarn's area and half the thickness does not fit");
    }
    fabric.yarn = {read.span.fill, read.area.fill, read.width.fill};
    fabric.warp.emplace();
    fabric.warp->yarn = {read.span.warp, read.area.warp, read.width.warp};
    fabric.warp->fill_crimp_height = height.fill;
    fabric.warp->crimp_height = height.warp;
    std::optional<double> expected;
    if (read.linear_density) expected = weight_of(fabric, *read.linear_density);
    fabric.areal_density = section.quantity("areal_density", areal_density, positive, expected);
    if (expected)
        section.refuse_if(
            std::abs(fabric.areal_density / *expected - 1) > most_apart, "areal_density",
            fmt::format("within 10 % of {}, which count and linear density give",
                        text_of(*expected, section.unit_of("areal_density", areal_density), 4)));
}

}  // namespace weavefront::scene
