#include <algorithm>

#include "parts.hpp"

namespace weavefront::scene {
namespace {

Friction read_coefficients(Section& section) {
    constexpr std::string_view of_static = "static", of_kinetic = "kinetic";
    Friction friction;
    friction.static_coefficient = section.quantity(of_static, ratio, non_negative);
    friction.kinetic_coefficient =
        section.quantity(of_kinetic, ratio, non_negative, friction.static_coefficient);
    section.refuse_if(friction.kinetic_coefficient > friction.static_coefficient, of_kinetic,
                      "at most static: sliding does not raise friction");
    friction.stiffness_ratio =
        section.quantity("stiffness_ratio", ratio, positive, Friction{}.stiffness_ratio);
    return friction;
}

}  // namespace

std::optional<Friction> read_friction(Section& section, std::optional<double> otherwise) {
    Friction friction;
    if (section.has_map("friction")) {
        friction = section.required("friction", read_coefficients);
    } else {
        friction.static_coefficient = section.quantity("friction", ratio, non_negative, otherwise);
        friction.kinetic_coefficient = friction.static_coefficient;
    }
    return friction.static_coefficient == 0 ? std::nullopt : std::optional(friction);
}

}  // namespace weavefront::scene
