#include <fmt/format.h>

#include <algorithm>

#include "parts.hpp"

namespace weavefront::scene {
namespace {

constexpr Range fraction{0, true, 1, " from 0 to 1"};
constexpr Range point_spacing{0, false, unbounded, " greater than 0 or the word nodes", "'0.25 mm'"};

ContactLaw read_law(Section& section, const ContactLaw& otherwise) {
    ContactLaw law;
    law.stiffness = section.quantity("stiffness", area_stiffness, positive, otherwise.stiffness);
    law.unloading = section.quantity("unloading", ratio, at_least_one, otherwise.unloading);
    law.damping = section.quantity("damping", ratio, fraction, otherwise.damping);
    law.friction = read_friction(section, 0.0);
    return law;
}

// So many points across the projectile integrate its pressure within some 2 %.
constexpr double points_across = 16;

/// Fine enough for the smallest projectile; where it is tiny, a hundredth of the largest element.
double default_spacing(const Target* target, std::span<const Projectile> projectiles) {
    double spacing = *Contact{}.spacing;
    if (target == nullptr) return spacing;
    for (const auto& projectile : projectiles) {
        const double across = std::max(projectile.diameter / points_across, target->mesh.edge / 100);
        if (across < spacing) spacing = across;  // not where it is not a number
    }
    return spacing;
}

/// @param target none: any spacing will do
std::optional<double> read_point_spacing(Section& section, const Target* target,
                                         std::span<const Projectile> projectiles) {
    constexpr double most_along_edge =
        1000;  // far below what a projectile's edge resolves, and memory of every point
    if (section.says("spacing", "nodes")) return std::nullopt;
    const double spacing =
        section.quantity("spacing", length, point_spacing, default_spacing(target, projectiles));
    if (target == nullptr) return spacing;
    const double finest = target->mesh.edge / most_along_edge;
    section.refuse_if(spacing < finest, "spacing",
                      fmt::format("at least {}, a thousandth of target.mesh.edge",
                                  at_least_text(finest, section.unit_of("spacing", length))));
    return spacing;
}

}  // namespace

Contact read_contact(Section& section, const Target* target, std::span<const Projectile> projectiles) {
    Contact contact;
    // Of the order of a yarn's transverse modulus over one ply spacing.
    const ContactLaw rigid = contact.frame;
    const ContactLaw plies{.stiffness = 1.1e13, .unloading = 10, .damping = 0.2};
    contact.spacing = read_point_spacing(section, target, projectiles);
    contact.projectile = section.optional("projectile", [&](Section& law) { return read_law(law, rigid); });
    section.refuse_if(!projectiles.empty() && !section.has("projectile"), "projectile",
                      "a map, such as {}, since there is a projectile");
    contact.plies = section.optional("plies", [&](Section& law) { return read_law(law, plies); });
    contact.frame =
        section.optional("frame", [&](Section& law) { return read_law(law, rigid); }).value_or(rigid);
    const bool has_frame = target != nullptr && target->frame;
    section.refuse_if(!has_frame && section.has("frame"), "frame",
                      "only with an edge that rests on the frame, such as target.edges: {x: frame}");
    return contact;
}

}  // namespace weavefront::scene
