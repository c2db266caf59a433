#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "warnings/subjects.hpp"

namespace weavefront::app {

namespace {

// Polypropylene 905 kg/m3, polyethylene 970, steel wire 7850.
constexpr double least_density = 800, most_density = 9000;

// Textile fibres: polyamide 6.6 about 3 GPa, pitch-based carbon 965 GPa (makers' data sheets). At impact
// rates none is stiffer than diamond, 1220 GPa.
constexpr double least_modulus = 1e9, most_modulus = 1000e9, most_instantaneous = 1220e9;

// Pitch-based carbon breaks at about 0.3 %, polyamide and undrawn polyester at 20 to 30 % (makers' data
// sheets).
constexpr double least_strain = 0.003, most_strain = 0.3;

// A yarn that relaxes a thousand times faster than the run ends is its static modulus, one a thousand times
// slower its Hooke spring.
constexpr double most_apart = 1e3;

// Yarn on yarn 0.1 to 0.4; more than this is wood on rubber.
constexpr double most_friction = 1;

// Full integration is 1: control of hourglass modes cannot need more than the stiffness that reduced
// integration has left out.
constexpr double most_hourglass = 1;

bool has_plausible_modulus(const scene::Elastic& elastic) {
    return elastic.static_modulus >= least_modulus && elastic.static_modulus <= most_modulus;
}

void warn_of_moduli(const Shot& shot, const NamedYarns& yarns, Phrases& found) {
    const auto modulus = [&](double value) { return text_of(value, shot.scene.units.modulus); };
    const auto& elastic = yarns.system.elastic;
    if (!has_plausible_modulus(elastic))
        found.push_back(fmt::format("{}: static_modulus is {}, fibres have {} to {}", yarns.name,
                                    modulus(elastic.static_modulus), modulus(least_modulus),
                                    modulus(most_modulus)));
    if (elastic.hooke_modulus > most_instantaneous)
        found.push_back(fmt::format("{}: hooke_modulus is {}, diamond has {}", yarns.name,
                                    modulus(elastic.hooke_modulus), modulus(most_instantaneous)));
}

// A fibre is stiffest along its axis.
void warn_of_stiff_sides(const Shot& shot, const scene::Fabric& fabric, Phrases& found) {
    const auto modulus = [&](double value) { return text_of(value, shot.scene.units.modulus); };
    const auto [fill, warp] = fabric.systems();
    const auto& elastic =
        fill.elastic.static_modulus < warp.elastic.static_modulus ? fill.elastic : warp.elastic;
    const auto warn_if_stiffer = [&](std::string_view key, double value) {
        if (has_plausible_modulus(elastic) && value > elastic.static_modulus)
            found.push_back(fmt::format("fabric {}: {} is {}, more than the {} of the yarns along their axis",
                                        fabric.name, key, modulus(value), modulus(elastic.static_modulus)));
    };
    warn_if_stiffer("transverse_shear", fabric.transverse_shear);
    if (!fabric.lateral) return;
    warn_if_stiffer("lateral.modulus", fabric.lateral->modulus);
    warn_if_stiffer("lateral.shear_modulus", fabric.lateral->shear_modulus);
}

void warn_of_viscosity(const Shot& shot, const NamedYarns& yarns, Phrases& found) {
    const auto& elastic = yarns.system.elastic;
    const double Ka = elastic.hooke_modulus, E1 = elastic.static_modulus, end = shot.scene.time.end;
    const double Kb = Ka * E1 / (Ka - E1), tau = elastic.viscosity / (Ka + Kb);  // IT04 (21), (14)
    const auto say = [&](std::string_view outcome) {
        found.push_back(fmt::format("{}: a viscosity of {} relaxes in {} and the run takes {}: {}",
                                    yarns.name, text_of(elastic.viscosity, shot.scene.units.viscosity),
                                    text_of(tau, shot.scene.units.time), text_of(end, shot.scene.units.time),
                                    outcome));
    };
    if (tau > 0 && tau * most_apart < end) say("yarns have no more than their static modulus");
    if (tau > end * most_apart) say("yarns do not relax from their Hooke modulus");
}

// Without viscosity sigma = E1 eps, so that the Hooke spring has strained by eps_a = E1/Ka eps, which is
// hooke_strain at Ka/E1 hooke_strain, IT04 (19); by (20) and (22) the other criterion is met at eps =
// static_strain.
void warn_of_failure(const NamedYarns& yarns, Phrases& found) {
    const auto& elastic = yarns.system.elastic;
    const auto& [static_strain, hooke_strain] = *yarns.system.strength;
    if (static_strain < least_strain || static_strain > most_strain)
        found.push_back(fmt::format("{}: static_strain is {:.4g} %, fibres break at {:.4g} to {:.4g} %",
                                    yarns.name, static_strain * 100, least_strain * 100, most_strain * 100));
    // Without an upper limit: a large one is how data of a slow test alone are entered.
    if (hooke_strain < least_strain)
        found.push_back(fmt::format("{}: hooke_strain is {:.4g} %, fibres break at {:.4g} to {:.4g} %",
                                    yarns.name, hooke_strain * 100, least_strain * 100, most_strain * 100));
    const double by_hooke = hooke_strain * elastic.hooke_modulus / elastic.static_modulus;
    if (elastic.viscosity == 0 && by_hooke < static_strain)
        found.push_back(
            fmt::format("{}: without viscosity yarns break at {:.4g} %, which hooke_strain decides "
                        "(hooke_strain times "
                        "hooke_modulus over static_modulus), before the static_strain of {:.4g} %",
                        yarns.name, by_hooke * 100, static_strain * 100));
}

}  // namespace

void warn_of_material(const Shot& shot, const scene::Fabric& fabric, Phrases& found) {
    if (fabric.density < least_density || fabric.density > most_density)
        found.push_back(fmt::format("fabric {}: the density is {}, fibres have {} to {}", fabric.name,
                                    text_of(fabric.density, shot.scene.units.density),
                                    text_of(least_density, shot.scene.units.density),
                                    text_of(most_density, shot.scene.units.density)));
    for (const auto& yarns : named_yarns(fabric)) {
        warn_of_moduli(shot, yarns, found);
        if (shot.has_plausible_end()) warn_of_viscosity(shot, yarns, found);
        if (fabric.failure) warn_of_failure(yarns, found);
    }
    warn_of_stiff_sides(shot, fabric, found);
    if (fabric.friction > most_friction)
        found.push_back(fmt::format("fabric {}: friction is {:.4g}, yarns on yarns have 0.1 to 0.4",
                                    fabric.name, fabric.friction));
    if (fabric.hourglass > most_hourglass)
        found.push_back(fmt::format("fabric {}: hourglass is {:.4g}, full integration has 1", fabric.name,
                                    fabric.hourglass));
}

}  // namespace weavefront::app
