#pragma once
/// @file
/// The scene that all cases and states change.

#include <string>

namespace weavefront::stability {

/// Three plies of the paper's fabric with every part of the model, a quarter of a small panel.
inline const std::string base_scene = R"(
fabrics:
  kevlar129:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}
    thickness: 0.41 mm
    contact_thickness: 0.1417 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    failure: {static_strain: 3.3 %, hooke_strain: 2.7 %}
    lateral: {modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 35 deg, transition: 3 deg}
    friction: 0.11
    transverse_shear: 2.5 GPa
target:
  size: [32 mm, 32 mm]
  plies: {count: 3, fabric: kevlar129, spacing: 0.25 mm}
  mesh: {center: 1 mm, edge: 2 mm}
  symmetry: [x, y]
projectile: {shape: cylinder, diameter: 5.38 mm, edge_radius: 0.3 mm, length: 16 mm, mass: 2.8 g, velocity: [0, 0, 200 m/s]}
contact:
  projectile: {}
  plies: {}
time: {end: 50 us}
output: {interval: 0, history: 1 us}
)";

}  // namespace weavefront::stability
