#include "library_projectiles.hpp"

#include <array>

#include "library_values.hpp"

namespace weavefront::scene {

void insert_standard_projectile(Value& scene, Findings& findings) {
    constexpr std::array<Replaced, 1> replaced{{{"apex_angle", "nose_length"}}};
    Entry* projectile = scene.kind == Value::Kind::map ? find(scene, "projectile") : nullptr;
    if (projectile == nullptr || projectile->left_out || projectile->value.kind != Value::Kind::map) return;
    insert_from_library(projectile->value, "standard", "projectile", projectile_library(), replaced,
                        findings);
}

}  // namespace weavefront::scene
