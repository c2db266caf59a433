#pragma once
/// @file
/// Projectiles for tests of shapes, 10 mm across and 30 mm long.

#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "random_points.hpp"
#include "weavefront/body/shape.hpp"

namespace weavefront::test {

constexpr double pi = std::numbers::pi, R = 5e-3, L = 30e-3, offset = 0.1e-3;

[[nodiscard]] inline scene::Projectile of_shape(scene::Shape shape) {
    scene::Projectile projectile;
    projectile.shape = shape;
    projectile.diameter = 2 * R;
    projectile.length = L;
    return projectile;
}

[[nodiscard]] inline scene::Projectile hemisphere() { return of_shape(scene::Shape::hemisphere); }

[[nodiscard]] inline scene::Projectile cone(double nose_length, double tip_radius = 0) {
    auto projectile = of_shape(scene::Shape::cone);
    projectile.nose_length = nose_length;
    projectile.tip_radius = tip_radius;
    return projectile;
}

[[nodiscard]] inline scene::Projectile truncated_cone(double nose_length, double tip_diameter) {
    auto projectile = of_shape(scene::Shape::truncated_cone);
    projectile.nose_length = nose_length;
    projectile.tip_diameter = tip_diameter;
    return projectile;
}

[[nodiscard]] inline scene::Projectile ogive(double caliber_radius_head, double tip_radius = 0) {
    auto projectile = of_shape(scene::Shape::ogive);
    projectile.caliber_radius_head = caliber_radius_head;
    projectile.tip_radius = tip_radius;
    return projectile;
}

[[nodiscard]] inline scene::Projectile fsp() {
    auto projectile = of_shape(scene::Shape::fsp);
    projectile.flat_width = 0.93 * R;
    projectile.flat_angle = 35 * pi / 180;
    return projectile;
}

[[nodiscard]] inline scene::Projectile box() {
    auto projectile = of_shape(scene::Shape::box);
    projectile.size = {8e-3, 6e-3, 20e-3};
    return projectile;
}

[[nodiscard]] inline scene::Projectile ring_segment() {
    auto projectile = of_shape(scene::Shape::ring_segment);
    projectile.outer_radius = 50e-3;
    projectile.thickness = 4e-3;
    projectile.width = 12e-3;
    projectile.sector = pi / 6;
    return projectile;
}

/// A hollow cup: its meridian is concave behind the rim, and sharp.
[[nodiscard]] inline scene::Projectile cup() {
    auto projectile = of_shape(scene::Shape::profile);
    projectile.profile = {{0, 0}, {3e-3, 4e-3}, {R, 4e-3}, {R, -10e-3}, {3e-3, -14e-3}, {3e-3, -L}, {0, -L}};
    return projectile;
}

}  // namespace weavefront::test
