#include "library_projectiles.hpp"

#include <array>
#include <string>

#include "library_values.hpp"

namespace weavefront::scene {

namespace {

void insert_standard(Value& projectile, const std::string& path, Findings& findings) {
    constexpr std::array<Replaced, 1> replaced{{{"apex_angle", "nose_length"}}};
    if (projectile.kind == Value::Kind::map)
        insert_from_library(projectile, "standard", path, projectile_library(), replaced, findings);
}

}  // namespace

void insert_standard_projectiles(Value& scene, Findings& findings) {
    const auto present = [&](const char* key) {
        Entry* entry = scene.kind == Value::Kind::map ? find(scene, key) : nullptr;
        return entry != nullptr && !entry->left_out ? entry : nullptr;
    };
    if (Entry* single = present("projectile")) insert_standard(single->value, "projectile", findings);
    if (Entry* list = present("projectiles"))
        for (std::size_t i = 0; i < list->value.items.size(); ++i)
            insert_standard(list->value.items[i], "projectiles." + std::to_string(i), findings);
}

}  // namespace weavefront::scene
