#pragma once
/// @file
/// The readers of the scene's sections. Each notes in the section what is wrong and returns what it could
/// read.

#include <optional>
#include <span>
#include <vector>

#include "section.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::scene {

/// `fabrics`: names to fabrics.
std::vector<Fabric> read_fabrics(Section& section);

/// Yarn, thickness and areal density of a fabric whose density is known.
void read_weave(Section& section, Fabric& fabric);

/// `target`.
Target read_target(Section& section, std::span<const Fabric> fabrics);

/// `target.plies`, a map for equal plies or a list; needs to know the symmetry.
std::vector<Ply> read_plies(Section& target, std::span<const Fabric> fabrics,
                            const std::array<bool, 2>& symmetry);

/// `projectile`, or the list `projectiles`. @param target null when the scene has none
std::vector<Projectile> read_projectiles(Section& scene, std::span<const Fabric> fabrics,
                                         const Target* target);

/// Shape and mass of a projectile.
void read_shape(Section& section, Projectile& projectile);

/// `orientation`, `spin` and the like of the projectile. @param target null when the scene has none
void read_attitude(Section& section, Projectile& projectile, const Target* target);

/// `friction` of a contact or a clamp; none where its coefficients are zero.
/// @param otherwise its default; absent: the key is required
std::optional<Friction> read_friction(Section& section, std::optional<double> otherwise);

/// `edges` and `frame` of the target, whose size is known.
void read_supports(Section& target_section, Target& target);

/// `contact`. @param target null: there is none
Contact read_contact(Section& section, const Target* target, std::span<const Projectile> projectiles);

/// `time`.
Scene::Time read_time(Section& section);

/// `limits`.
Scene::Limits read_limits(Section& section);

/// `output`. @param end of the run, s
Output read_output(Section& section, double end);

/// The scene as YAML with every default written out. Parses again to the same scene, bit for bit.
std::string resolved_text(const Scene& scene);

}  // namespace weavefront::scene
