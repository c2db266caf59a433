#include "parts.hpp"

namespace weavefront::scene {
namespace {

constexpr Range fraction{0, true, 1, " from 0 to 1"};

ContactLaw read_law(Section& section, const ContactLaw& otherwise) {
    ContactLaw law;
    law.stiffness = section.quantity("stiffness", area_stiffness, positive, otherwise.stiffness);
    law.unloading = section.quantity("unloading", ratio, at_least_one, otherwise.unloading);
    law.damping = section.quantity("damping", ratio, fraction, otherwise.damping);
    section.unavailable({"friction"});
    return law;
}

std::optional<double> read_point_spacing(Section& section) {
    if (section.says("spacing", "nodes")) return std::nullopt;
    return section.quantity("spacing", length, positive, Contact{}.spacing);
}

}  // namespace

Contact read_contact(Section& section, bool has_frame) {
    Contact contact;
    // Of the order of a yarn's transverse modulus over one ply spacing.
    const ContactLaw rigid = contact.frame;
    const ContactLaw plies{.stiffness = 1.1e13, .unloading = 10, .damping = 0.2};
    contact.spacing = read_point_spacing(section);
    contact.projectile = section.optional("projectile", [&](Section& law) { return read_law(law, rigid); });
    contact.plies = section.optional("plies", [&](Section& law) { return read_law(law, plies); });
    contact.frame = section.optional("frame", [&](Section& law) { return read_law(law, rigid); }).value_or(rigid);
    section.refuse_if(!has_frame && section.has("frame"), "frame", "only with an edge that rests on the frame (target.edges)");
    section.unavailable({"friction"});
    return contact;
}

}  // namespace weavefront::scene
