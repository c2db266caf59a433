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

void warn_of_moduli(const Shot& shot, const scene::Fabric& fabric, Phrases& found) {
    const auto modulus = [&](double value) { return text_of(value, shot.scene.units.modulus); };
    const double static_modulus = fabric.elastic.static_modulus, hooke_modulus = fabric.elastic.hooke_modulus;
    const bool plausible = static_modulus >= least_modulus && static_modulus <= most_modulus;
    if (!plausible)
        found.push_back(fmt::format("fabric {}: static_modulus is {}, fibres have {} to {}", fabric.name,
                                    modulus(static_modulus), modulus(least_modulus), modulus(most_modulus)));
    if (hooke_modulus > most_instantaneous)
        found.push_back(fmt::format("fabric {}: hooke_modulus is {}, diamond has {}", fabric.name,
                                    modulus(hooke_modulus), modulus(most_instantaneous)));
    // A fibre is stiffest along its axis.
    const auto warn_if_stiffer = [&](std::string_view key, double value) {
        if (plausible && value > static_modulus)
            found.push_back(fmt::format("fabric {}: {} is {}, more than the {} of the yarns along their axis",
                                        fabric.name, key, modulus(value), modulus(static_modulus)));
    };
    warn_if_stiffer("transverse_shear", fabric.transverse_shear);
    if (!fabric.lateral) return;
    warn_if_stiffer("lateral.modulus", fabric.lateral->modulus);
    warn_if_stiffer("lateral.shear_modulus", fabric.lateral->shear_modulus);
}

void warn_of_viscosity(const Shot& shot, const scene::Fabric& fabric, Phrases& found) {
    const double Ka = fabric.elastic.hooke_modulus, E1 = fabric.elastic.static_modulus,
                 end = shot.scene.time.end;
    const double Kb = Ka * E1 / (Ka - E1), tau = fabric.elastic.viscosity / (Ka + Kb);  // IT04 (21), (14)
    const auto say = [&](std::string_view outcome) {
        found.push_back(
            fmt::format("fabric {}: a viscosity of {} relaxes in {} and the run takes {}: {}", fabric.name,
                        text_of(fabric.elastic.viscosity, shot.scene.units.viscosity),
                        text_of(tau, shot.scene.units.time), text_of(end, shot.scene.units.time), outcome));
    };
    if (tau > 0 && tau * most_apart < end) say("yarns have no more than their static modulus");
    if (tau > end * most_apart) say("yarns do not relax from their Hooke modulus");
}

// Without viscosity sigma = E1 eps, so that the Hooke spring has strained by eps_a = E1/Ka eps, which is
// hooke_strain at Ka/E1 hooke_strain, IT04 (19); by (20) and (22) the other criterion is met at eps =
// static_strain.
void warn_of_failure(const scene::Fabric& fabric, Phrases& found) {
    const auto& [static_strain, hooke_strain, erode] = *fabric.failure;
    if (static_strain < least_strain || static_strain > most_strain)
        found.push_back(
            fmt::format("fabric {}: static_strain is {:.4g} %, fibres break at {:.4g} to {:.4g} %",
                        fabric.name, static_strain * 100, least_strain * 100, most_strain * 100));
    // Without an upper limit: a large one is how data of a slow test alone are entered.
    if (hooke_strain < least_strain)
        found.push_back(fmt::format("fabric {}: hooke_strain is {:.4g} %, fibres break at {:.4g} to {:.4g} %",
                                    fabric.name, hooke_strain * 100, least_strain * 100, most_strain * 100));
    const double by_hooke = hooke_strain * fabric.elastic.hooke_modulus / fabric.elastic.static_modulus;
    if (fabric.elastic.viscosity == 0 && by_hooke < static_strain)
        found.push_back(
            fmt::format("fabric {}: without viscosity yarns break at {:.4g} %, which hooke_strain decides "
                        "(hooke_strain times "
                        "hooke_modulus over static_modulus), before the static_strain of {:.4g} %",
                        fabric.name, by_hooke * 100, static_strain * 100));
}

}  // namespace

void warn_of_material(const Shot& shot, const scene::Fabric& fabric, Phrases& found) {
    if (fabric.density < least_density || fabric.density > most_density)
        found.push_back(fmt::format("fabric {}: the density is {}, fibres have {} to {}", fabric.name,
                                    text_of(fabric.density, shot.scene.units.density),
                                    text_of(least_density, shot.scene.units.density),
                                    text_of(most_density, shot.scene.units.density)));
    warn_of_moduli(shot, fabric, found);
    if (shot.has_plausible_end()) warn_of_viscosity(shot, fabric, found);
    if (fabric.failure) warn_of_failure(fabric, found);
    if (fabric.friction > most_friction)
        found.push_back(fmt::format("fabric {}: friction is {:.4g}, yarns on yarns have 0.1 to 0.4",
                                    fabric.name, fabric.friction));
    if (fabric.hourglass > most_hourglass)
        found.push_back(fmt::format("fabric {}: hourglass is {:.4g}, full integration has 1", fabric.name,
                                    fabric.hourglass));
}

}  // namespace weavefront::app
