#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "both.hpp"
#include "parts.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::scene {
namespace {

// Below 1 links of no strength would be the most frequent.
constexpr Range weibull{1, true, 1000, " of 1 to 1000", "'20'"};
// Every whole number up to 2^53 is a double, as scenes are read.
constexpr std::int64_t most_seeds = std::int64_t{1} << 53;

constexpr double diagonal = std::numbers::pi / 4;
constexpr Range strain{0, false, 1, " greater than 0 and at most 100 %", "'0.03' or '3 %'"};
const MessageUnit degrees{"deg", std::numbers::pi / 180};

/// Elastic constants of fill and warp.
struct BothElastic {
    Elastic fill, warp;
};

BothElastic read_elastic(Section& section) {
    if (section.has("modulus")) {
        for (const std::string_view key : {"static_modulus", "hooke_modulus", "viscosity"})
            section.refuse_if(section.has(key), key, "none beside modulus, which means no rate effect");
        const Both E = both(section, "modulus", modulus, positive);
        // without viscosity the Hooke spring decides nothing
        return {{E.fill, 2 * E.fill, 0}, {E.warp, 2 * E.warp, 0}};
    }
    const Both E1 = both(section, "static_modulus", modulus, positive);
    const Both Ka = both(section, "hooke_modulus", modulus, positive);
    const Both mu_b = both(section, "viscosity", viscosity, non_negative, 0);
    section.refuse_if(
        Ka.fill <= E1.fill || Ka.warp <= E1.warp, "hooke_modulus",
        fmt::format("more than static_modulus, {}", text_of(Ka.fill <= E1.fill ? E1.fill : E1.warp,
                                                            section.unit_of("hooke_modulus", modulus), 6)));
    return {{E1.fill, Ka.fill, mu_b.fill}, {E1.warp, Ka.warp, mu_b.warp}};
}

Scatter read_scatter(Section& section) {
    Scatter scatter;
    scatter.weibull_modulus = section.quantity("weibull_modulus", ratio, weibull);
    scatter.gauge_length = section.quantity("gauge_length", length, positive);
    if (section.has("seed")) scatter.seed = section.count("seed", most_seeds);
    return scatter;
}

/// Failure of the fill, and failure strains of the warp.
struct BothFailure {
    Failure fill;
    Strength warp;
};

BothFailure read_failure(Section& section, const Fabric& fabric) {
    BothFailure failure;
    const auto assign = [&](const Both& static_strain, const Both& hooke_strain) {
        failure.fill.static_strain = static_strain.fill;
        failure.fill.hooke_strain = hooke_strain.fill;
        failure.warp = {static_strain.warp, hooke_strain.warp};
    };
    if (section.has("strain")) {
        section.refuse_if(fabric.elastic.viscosity > 0 || fabric.warp->elastic.viscosity > 0, "strain",
                          "static_strain and hooke_strain, since the yarn has a viscosity");
        for (const std::string_view key : {"static_strain", "hooke_strain"})
            section.refuse_if(section.has(key), key, "none beside strain");
        const Both of_yarn = both(section, "strain", ratio, strain);
        assign(of_yarn, of_yarn);  // of the smaller part of the strain, the Hooke spring: never decides
    } else {
        const Both static_strain = both(section, "static_strain", ratio, strain);
        assign(static_strain, both(section, "hooke_strain", ratio, strain));
    }
    failure.fill.erode = section.choice("erode", erode_names, failure.fill.erode);
    failure.fill.scatter = section.optional("scatter", read_scatter);
    return failure;
}

Lateral read_lateral(Section& section, const Fabric& fabric) {
    Lateral lateral;
    lateral.modulus = section.quantity("modulus", modulus, positive);
    lateral.shear_modulus = section.quantity("shear_modulus", modulus, positive);
    // IT04 (1), of the yarns that touch first
    const double theta_min = arc_sine(std::max(fabric.yarn.width / fabric.warp->yarn.span,
                                               fabric.warp->yarn.width / fabric.yarn.span)) /
                             2;
    lateral.locking_angle = section.quantity("locking_angle", angle, any_value, diagonal - theta_min);
    lateral.transition = section.quantity("transition", angle, positive);
    section.refuse_if(lateral.locking_angle <= 0 || lateral.locking_angle >= diagonal, "locking_angle",
                      "an angle greater than 0 deg and less than 45 deg");
    section.refuse_if(
        lateral.locking_angle > 0 && lateral.transition >= lateral.locking_angle, "transition",
        fmt::format("less than the locking angle, {}", text_of(lateral.locking_angle, degrees, 6)));
    return lateral;
}

struct ContactThickness {
    double value;  ///< m
    const char* source;
};

/// Distance at which two plies touch when nothing is said: the fabric's own thickness. A crimp height that
/// stands for more than the geometry says nothing of it, and fibre without air is the least.
ContactThickness default_contact_thickness(const Fabric& fabric) {
    const bool is_geometric = fabric.crimp() <= most_crimp && fabric.thickness > fabric.effective_thickness();
    if (is_geometric) return {fabric.thickness, "thickness"};
    return {fabric.effective_thickness(), "areal_density / density"};
}

/// Values that could not be read, NaN, count as equal.
bool has_equal_yarns(const Fabric& fabric) {
    const auto values = [](const YarnSystem& of) {
        const auto strength = of.strength.value_or(Strength{});
        return std::array{of.yarn.span,
                          of.yarn.area,
                          of.yarn.width,
                          of.crimp_height,
                          of.elastic.static_modulus,
                          of.elastic.hooke_modulus,
                          of.elastic.viscosity,
                          strength.static_strain,
                          strength.hooke_strain};
    };
    return std::ranges::equal(values(fabric.fill_system()), values(fabric.warp_system()),
                              [](double fill, double warp) { return !(fill < warp) && !(fill > warp); });
}

Fabric read_fabric(Section& section) {
    Fabric fabric;
    (void)section.has("library");  // a known key, replaced by the values that it stands for
    fabric.formulation = section.choice("formulation", formulation_names, fabric.formulation);
    fabric.density = section.quantity("density", density, positive);
    read_weave(section, fabric);
    const BothElastic elastic = section.required("elastic", read_elastic);
    fabric.elastic = elastic.fill;
    fabric.warp->elastic = elastic.warp;
    const auto failure = section.optional("failure", [&](Section& map) { return read_failure(map, fabric); });
    if (failure) {
        fabric.failure = failure->fill;
        fabric.warp->strength = failure->warp;
    }
    fabric.lateral =
        section.optional("lateral", [&](Section& lateral) { return read_lateral(lateral, fabric); });
    fabric.friction = section.quantity("friction", ratio, non_negative, 0);
    fabric.transverse_shear = section.quantity("transverse_shear", modulus, non_negative, 0);
    fabric.hourglass = section.quantity("hourglass", ratio, non_negative, fabric.hourglass);
    const ContactThickness otherwise = default_contact_thickness(fabric);
    fabric.contact_thickness = section.quantity("contact_thickness", length, positive, otherwise.value);
    fabric.contact_thickness_source =
        section.has("contact_thickness") ? "contact_thickness" : otherwise.source;
    if (has_equal_yarns(fabric)) fabric.warp.reset();
    section.refuse_if(fabric.warp && fabric.formulation == Formulation::paper, "formulation",
                      "consistent, since fill and warp differ: the paper's cell has equal yarns");
    section.refuse_if(fabric.failure && fabric.failure->scatter && fabric.formulation == Formulation::paper,
                      "formulation", "consistent, since the strength is scattered");
    return fabric;
}

}  // namespace

std::vector<Fabric> read_fabrics(Section& section) {
    constexpr std::size_t most_fabrics = 1000;
    std::vector<Fabric> fabrics;
    const std::vector<std::string> names = section.keys();
    section.require_at_most("", names.size(), most_fabrics, "fabrics");
    for (const std::string& name : names) {
        // The paths of overrides and messages have dots between keys.
        if (name.empty() || name.find_first_of(".=") != name.npos)
            section.refuse(name, fmt::format("the name '{}'", printable(name)),
                           "a name of at least one letter without '.' and '='");
        fabrics.push_back(section.required(name, read_fabric));
        fabrics.back().name = name;
    }
    return fabrics;
}

}  // namespace weavefront::scene
