#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "attitude.hpp"
#include "parts.hpp"

namespace weavefront::scene {
namespace {

constexpr std::array<double, 3> x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

double length_of(std::span<const double> list) {
    double square = 0;
    for (const double value : list) square += value * value;
    return std::sqrt(square);
}

Quaternion read_axis_and_angle(Section& section) {
    const auto axis = section.vector<3>("axis", ratio, any_value);
    section.refuse_if(length_of(axis) == 0, "axis", "a vector that is not 0");
    return about(axis, section.quantity("angle", angle, any_value));
}

Quaternion read_quaternion(Section& section) {
    const auto q = section.vector<4>("quaternion", ratio, any_value);
    section.refuse_if(length_of(q) == 0, "quaternion", "a vector that is not 0");
    return normalized(q);
}

/// The nose turns towards +x by the yaw and towards +y by the pitch; the roll about its own axis comes first.
Quaternion read_angles(Section& section) {
    const double yaw = section.quantity("yaw", angle, any_value, 0),
                 pitch = section.quantity("pitch", angle, any_value, 0),
                 roll = section.quantity("roll", angle, any_value, 0);
    return product(product(about(y_axis, yaw), about(x_axis, -pitch)), about(z_axis, roll));
}

Quaternion read_orientation(Section& section) {
    if (section.has("quaternion")) return read_quaternion(section);
    if (section.has("axis") || section.has("angle")) return read_axis_and_angle(section);
    return read_angles(section);
}

void read_spin(Section& section, Projectile& projectile) {
    if (section.has("spin")) {
        section.refuse_if(section.has("angular_velocity"), "spin", "spin or angular_velocity");
        const double spin = section.quantity("spin", angular_rate, any_value);
        const auto axis = turned_axis(projectile.attitude, 2);
        for (std::size_t i = 0; i < 3; ++i) projectile.angular_velocity[i] = spin * axis[i];
    } else {
        projectile.angular_velocity =
            section.vector<3>("angular_velocity", angular_rate, any_value, std::array<double, 3>{0, 0, 0});
    }
}

void read_inertia(Section& section, Projectile& projectile) {
    if (!section.has("inertia")) return;
    projectile.inertia = section.vector<3>("inertia", moment_of_inertia, positive);
    const auto& [x, y, z] = *projectile.inertia;
    section.refuse_if(x > y + z || y > z + x || z > x + y, "inertia",
                      "three moments of which none is more than the sum of the others");
}

/// Whether the turned shape is its own mirror image about a plane through its axis: a body of revolution with
/// its axis in the plane, another one with its own plane of symmetry there.
bool is_symmetric(const Projectile& projectile, std::size_t plane) {
    constexpr double rounding = 1e-12;
    const auto along_normal = [&](std::size_t axis) {
        return std::abs(turned_axis(projectile.attitude, axis)[plane]);
    };
    switch (projectile.shape) {
        case Shape::box:
        case Shape::fsp:
        case Shape::ring_segment:
            return std::max(along_normal(0), along_normal(1)) > 1 - rounding;
        case Shape::mesh:
            return along_normal(plane) > 1 - rounding;
        default:
            return along_normal(2) < rounding;
    }
}

/// The mirror image turns the other way about every axis but the normal of the plane of symmetry.
void check_symmetry(Section& section, const Projectile& projectile, const Target& target) {
    const std::string_view spin = section.has("spin") ? "spin" : "angular_velocity";
    for (const auto& [name, plane] : axis_names) {
        if (!target.symmetry[plane]) continue;
        section.refuse_if(
            !is_symmetric(projectile, plane), "orientation",
            fmt::format("one with which the projectile is its own mirror image about {} = 0", name));
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (axis != plane && std::abs(projectile.angular_velocity[axis]) > 0) {
                section.refuse_if(true, spin,
                                  fmt::format("with symmetry {0} a rotation about {0} only", name));
                break;
            }
    }
}

}  // namespace

void read_attitude(Section& section, Projectile& projectile, const Target* target) {
    if (const auto attitude = section.optional("orientation", read_orientation))
        projectile.attitude = *attitude;
    const bool is_fixed = section.choice("fixed", fixed_names, Fixed::nothing) == Fixed::rotation;
    read_spin(section, projectile);
    read_inertia(section, projectile);
    const bool both = target != nullptr && target->symmetry[0] && target->symmetry[1];
    projectile.turns = !is_fixed && !both;
    if (is_fixed)
        for (const std::string_view key : {"spin", "angular_velocity", "inertia"})
            section.refuse_if(section.has(key), key, "none with fixed: rotation");
    if (target != nullptr) check_symmetry(section, projectile, *target);
}

}  // namespace weavefront::scene
