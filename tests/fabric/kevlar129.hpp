#pragma once
/// @file
/// The fabric of IT04 section 3: Kevlar 129, 840 denier, plain weave, 11 yarns/cm.

#include <numbers>

#include "weavefront/scene/scene.hpp"

namespace weavefront::test {

inline constexpr double degree = std::numbers::pi / 180;

[[nodiscard]] inline scene::Fabric kevlar129() {
    scene::Fabric fabric;
    fabric.name = "kevlar129";
    fabric.areal_density = 0.204;
    fabric.density = 1440;
    fabric.yarn = {.span = 0.909e-3, .area = 6.48e-8, .width = 0.32e-3};
    fabric.thickness = 0.82e-3;
    fabric.elastic = {.static_modulus = 96e9, .hooke_modulus = 192e9, .viscosity = 35e6};
    fabric.failure = scene::Failure{.static_strain = 0.033, .hooke_strain = 0.027};
    fabric.lateral = scene::Lateral{
        .modulus = 7.4e9, .shear_modulus = 2.5e9, .locking_angle = 35 * degree, .transition = 3 * degree};
    fabric.friction = 0.11;
    fabric.transverse_shear = 2.5e9;
    return fabric;
}

/// Its fill with a denser, thicker and softer warp of more crimp.
[[nodiscard]] inline scene::Fabric unequal_kevlar129() {
    scene::Fabric fabric = kevlar129();
    fabric.thickness = 2 * (0.10e-3 + 0.25e-3);
    fabric.warp = {.yarn = {.span = 0.8e-3, .area = 8.1e-8, .width = 0.45e-3},
                   .elastic = {.static_modulus = 80e9, .hooke_modulus = 150e9, .viscosity = 20e6},
                   .strength = {.static_strain = 0.04, .hooke_strain = 0.03},
                   .crimp_height = 0.25e-3,
                   .fill_crimp_height = 0.10e-3};
    return fabric;
}

/// A fabric without viscosity, so that closed paths can be walked at any pace.
[[nodiscard]] inline scene::Fabric elastic(scene::Fabric fabric) {
    fabric.elastic.viscosity = 0;
    if (fabric.warp) fabric.warp->elastic.viscosity = 0;
    fabric.failure.reset();
    return fabric;
}

[[nodiscard]] inline scene::Fabric elastic_kevlar129() { return elastic(kevlar129()); }

}  // namespace weavefront::test
