#pragma once
/// @file
/// All state of one element, named once for migration and checkpoints.

#include <cstdint>

#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// @param element owned, local
template <class Archive>
void visit_element(Archive& archive, Model& model, std::int32_t element) {
    const auto slot = model.slots[static_cast<std::size_t>(element)];
    auto& group = *model.groups[static_cast<std::size_t>(slot.group)];
    archive.within("fabric", [&] { group.state(archive, slot.index); });
    if (!group.alive(slot.index)) {
        model.surface.alive[static_cast<std::size_t>(element)] = 0;
        archive.within("at_erosion", [&] { model.eroded[element].state(archive); });
    }
    for (auto& projectile : model.projectiles)
        if (projectile.contact)
            archive.within(projectile.contact_name, [&] { projectile.contact->state(archive, element); });
    if (model.ply_contact) archive.within("ply_contact", [&] { model.ply_contact->state(archive, element); });
    if (model.frame_contact)
        archive.within("frame_contact", [&] { model.frame_contact->state(archive, element); });
}

/// Position and velocity of a local node, and its friction in a clamp.
template <class Archive>
void visit_node(Archive& archive, Model& model, std::size_t node) {
    auto &x = model.nodes.x[node], &v = model.nodes.v[node];
    archive("x", x[0]), archive("y", x[1]), archive("z", x[2]);
    archive("vx", v[0]), archive("vy", v[1]), archive("vz", v[2]);
    if (model.clamp_friction) model.clamp_friction->state(archive, node);
}

}  // namespace weavefront::solver
