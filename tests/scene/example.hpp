#pragma once

#include <string>
#include <vector>

#include "weavefront/scene/read.hpp"

namespace weavefront::scene::test {

/// A scene that uses most keys; the line numbers in expected messages count from `title` as line 1.
inline const std::string example = R"(title: Eight plies of Kevlar 129 at 428 m/s
fabrics:
  kevlar129:
    formulation: consistent            # or paper
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}
    thickness: 0.820 mm                # crimp height t of the cell
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    failure: {static_strain: 3.3 %, hooke_strain: 2.7 %, erode: both_yarns}     # leave out: nothing breaks
    lateral: {modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 35 deg, transition: 3 deg}
    friction: 0.11                     # yarn on yarn; leave out: none
    transverse_shear: 2.5 GPa
target:
  size: [203.2 mm, 203.2 mm]
  plies: {count: 8, fabric: kevlar129, spacing: 0.25 mm}    # or a list, one entry a ply, each with its own fabric and angle
  mesh: {center: 1 mm, edge: 3 mm, growth: 1.08}
  symmetry: [x, y]
  edges: {x: fixed, y: fixed}          # fixed | sliding | frame | free
projectile: {shape: cylinder, diameter: 5.38 mm, edge_radius: 0.3 mm, mass: 2.8 g, velocity: [0, 0, 428 m/s]}
contact:
  spacing: 0.25 mm                     # integration points of an element at most this far apart; `nodes`: at its nodes only
  projectile: {stiffness: 5.6e12 N/m^3, unloading: 10}      # unloading slope over loading slope; 1: elastic
  plies: {stiffness: 1.1e13 N/m^3, unloading: 10, damping: 0.2}
time: {end: 200 us, safety: 0.9}
output: {interval: 5 us, fields: [displacement, stress, broken], history: 0.5 us}
)";

/// The example with `from`, which must occur, replaced by `to`.
inline std::string example_with(const std::string& from, const std::string& to) {
    std::string text = example;
    const std::size_t at = text.find(from);
    if (at == text.npos) throw std::logic_error("the example has no '" + from + "'");
    return text.replace(at, from.size(), to);
}

inline Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_scene(text, "s.yaml", overrides);
}

/// What parsing says is wrong; empty: nothing.
inline std::vector<std::string> findings(const std::string& text,
                                         const std::vector<std::string>& overrides = {},
                                         Need need = Need::impact) {
    try {
        parse_scene(text, "s.yaml", overrides, need);
    } catch (const InputError& error) {
        return error.messages();
    }
    return {};
}

}  // namespace weavefront::scene::test
