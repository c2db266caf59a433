#pragma once
/// @file
/// Warnings by subject. Each function adds its phrases to a list.

#include <string>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

using Phrases = std::vector<std::string>;

/// What the rules have in common.
struct Shot {
    const scene::Scene& scene;
    const mesh::Panel& panel;
    double time_step;  ///< s; 0: not known
    double speed;      ///< of the fastest projectile, m/s; 0: none
    double wave;       ///< largest speed of the longitudinal wave in the yarns, m/s

    /// When the projectile or the wave, the slower one, has crossed the target, s.
    [[nodiscard]] double crossing() const;
    /// Whether the run ends neither before the wave has gone as far as the projectile is wide, nor long after
    /// all has happened: what is compared with an end of another size is told of the end alone.
    [[nodiscard]] bool has_plausible_end() const;

    [[nodiscard]] const scene::Fabric& fabric_of(const scene::Ply& ply) const {
        return scene.fabrics[static_cast<std::size_t>(ply.fabric)];
    }
    [[nodiscard]] const scene::Fabric& struck() const { return fabric_of(panel.plies.front()); }
};

/// Yarns of a fabric and what messages call them.
struct NamedYarns {
    std::string name;
    scene::YarnSystem system;
};

/// Fill and warp where they differ, else the yarns of both.
std::vector<NamedYarns> named_yarns(const scene::Fabric& fabric);

/// Whether the areal density is about that of the yarns.
bool has_plausible_weight(const scene::Fabric& fabric);

/// Geometry and mass of the weave.
void warn_of_weave(const Shot& shot, const scene::Fabric& fabric, Phrases& found);
/// Moduli, viscosity, failure strains and friction.
void warn_of_material(const Shot& shot, const scene::Fabric& fabric, Phrases& found);
/// Size, plies, mesh and frame of the target.
void warn_of_target(const Shot& shot, Phrases& found);
/// Mass, shape and way of a projectile, and contact that it escapes.
void warn_of_projectile(const Shot& shot, const scene::Projectile& projectile, Phrases& found);
/// Projectiles that start inside each other.
void warn_of_overlaps(const scene::Scene& scene, Phrases& found);
/// Contact that is too soft or too coarse for a projectile, or that it escapes.
void warn_of_projectile_contact(const Shot& shot, const scene::Projectile& projectile, Phrases& found);
/// Contact of the frame, and friction.
void warn_of_contact(const Shot& shot, Phrases& found);
/// Time, output, damping and limits.
void warn_of_controls(const Shot& shot, Phrases& found);

/// Where the middle of the nose meets the first ply if nothing deflects it, m. @param z of the meeting, m
std::array<double, 2> place_at(const scene::Projectile& projectile, double z);

}  // namespace weavefront::app
