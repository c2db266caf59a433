#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

constexpr double diagonal = std::numbers::pi / 4;
constexpr Range strain{0, false, 1, " greater than 0 and at most 100 %", "'0.03' or '3 %'"};
const MessageUnit degrees{"deg", std::numbers::pi / 180};

Elastic read_elastic(Section& section) {
    Elastic elastic;
    if (section.has("modulus")) {
        for (const std::string_view key : {"static_modulus", "hooke_modulus", "viscosity"})
            section.refuse_if(section.has(key), key, "none beside modulus, which means no rate effect");
        elastic.static_modulus = section.quantity("modulus", modulus, positive);
        elastic.hooke_modulus = 2 * elastic.static_modulus;  // decides nothing without viscosity
        elastic.viscosity = 0;
        return elastic;
    }
    elastic.static_modulus = section.quantity("static_modulus", modulus, positive);
    elastic.hooke_modulus = section.quantity("hooke_modulus", modulus, positive);
    elastic.viscosity = section.quantity("viscosity", viscosity, non_negative, 0);
    section.refuse_if(
        elastic.hooke_modulus <= elastic.static_modulus, "hooke_modulus",
        fmt::format("more than static_modulus, {}",
                    text_of(elastic.static_modulus, section.unit_of("hooke_modulus", modulus), 6)));
    return elastic;
}

Failure read_failure(Section& section, const Elastic& elastic) {
    Failure failure;
    if (section.has("strain")) {
        section.refuse_if(elastic.viscosity > 0, "strain",
                          "static_strain and hooke_strain, since the yarn has a viscosity");
        for (const std::string_view key : {"static_strain", "hooke_strain"})
            section.refuse_if(section.has(key), key, "none beside strain");
        failure.static_strain = section.quantity("strain", ratio, strain);
        failure.hooke_strain = failure.static_strain;  // of the smaller part of the strain: never decides
        failure.erode = section.choice("erode", erode_names, failure.erode);
        return failure;
    }
    failure.static_strain = section.quantity("static_strain", ratio, strain);
    failure.hooke_strain = section.quantity("hooke_strain", ratio, strain);
    failure.erode = section.choice("erode", erode_names, failure.erode);
    return failure;
}

Lateral read_lateral(Section& section, const Yarn& yarn) {
    Lateral lateral;
    lateral.modulus = section.quantity("modulus", modulus, positive);
    lateral.shear_modulus = section.quantity("shear_modulus", modulus, positive);
    const double theta_min = std::asin(yarn.width / yarn.span) / 2;  // IT04 (1)
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

Fabric read_fabric(Section& section) {
    Fabric fabric;
    (void)section.has("library");  // a known key, replaced by the values that it stands for
    fabric.formulation = section.choice("formulation", formulation_names, fabric.formulation);
    fabric.density = section.quantity("density", density, positive);
    read_weave(section, fabric);
    fabric.elastic = section.required("elastic", read_elastic);
    fabric.failure =
        section.optional("failure", [&](Section& failure) { return read_failure(failure, fabric.elastic); });
    fabric.lateral =
        section.optional("lateral", [&](Section& lateral) { return read_lateral(lateral, fabric.yarn); });
    fabric.friction = section.quantity("friction", ratio, non_negative, 0);
    fabric.transverse_shear = section.quantity("transverse_shear", modulus, non_negative, 0);
    fabric.hourglass = section.quantity("hourglass", ratio, non_negative, fabric.hourglass);
    const ContactThickness otherwise = default_contact_thickness(fabric);
    fabric.contact_thickness = section.quantity("contact_thickness", length, positive, otherwise.value);
    fabric.contact_thickness_source =
        section.has("contact_thickness") ? "contact_thickness" : otherwise.source;
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
