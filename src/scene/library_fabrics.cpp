#include "library_fabrics.hpp"

#include <fmt/format.h>

#include <array>

#include "library_values.hpp"

namespace weavefront::scene {
namespace {

constexpr std::array<Replaced, 21> replaced{{
    {"count", "yarn.span"},
    {"yarn.span", "count"},
    {"yarn.area", "yarn.denier"},
    {"yarn.area", "yarn.dtex"},
    {"yarn.denier", "yarn.area"},
    {"yarn.denier", "yarn.dtex"},
    {"yarn.dtex", "yarn.area"},
    {"yarn.dtex", "yarn.denier"},
    {"crimp", "thickness"},
    {"crimp_height", "thickness"},
    {"count", "areal_density"},
    {"yarn.span", "areal_density"},
    {"yarn.denier", "areal_density"},
    {"yarn.dtex", "areal_density"},
    {"elastic.modulus", "elastic.static_modulus"},
    {"elastic.modulus", "elastic.hooke_modulus"},
    {"elastic.modulus", "elastic.viscosity"},
    {"elastic.static_modulus", "elastic.modulus"},
    {"failure.strain", "failure.static_strain"},
    {"failure.strain", "failure.hooke_strain"},
    {"failure.static_strain", "failure.strain"},
}};

}  // namespace

void insert_library_fabrics(Value& scene, Findings& findings) {
    Entry* fabrics = scene.kind == Value::Kind::map ? find(scene, "fabrics") : nullptr;
    if (fabrics == nullptr || fabrics->value.kind != Value::Kind::map) return;
    for (auto& fabric : fabrics->value.entries)
        if (fabric.value.kind == Value::Kind::map)
            insert_from_library(fabric.value, "library", fmt::format("fabrics.{}", fabric.key),
                                fabric_library(), replaced, findings);
}

}  // namespace weavefront::scene
