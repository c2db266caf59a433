#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parts.hpp"
#include "projectile_files.hpp"
#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::scene {
namespace {

constexpr double steel = 7850;  // kg/m3

// std::hypot has other last bits on processors with fused operations.
double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

double steel_length(const Projectile& projectile) {
    const double section = std::numbers::pi / 4 * projectile.diameter * projectile.diameter;
    return std::max(projectile.mass / (steel * section), 2 * projectile.edge_radius);
}

/// Refuses a length that is more than another one. @param bound its name, in messages
void require_at_most(Section& section, std::string_view key, double value, double most,
                     std::string_view bound) {
    section.refuse_if(value > most, key,
                      fmt::format("at most {}, {}", at_most_text(most, section.unit_of(key, length)), bound));
}

void require_at_least(Section& section, std::string_view key, double value, double least,
                      std::string_view bound) {
    section.refuse_if(
        value < least, key,
        fmt::format("at least {}, {}", at_least_text(least, section.unit_of(key, length)), bound));
}

void read_cylinder(Section& section, Projectile& projectile) {
    projectile.edge_radius = section.quantity("edge_radius", length, non_negative, 0);
    require_at_most(section, "edge_radius", projectile.edge_radius, projectile.diameter / 2,
                    "half the diameter");
    projectile.length = section.quantity("length", length, positive, steel_length(projectile));
    require_at_least(section, "length", projectile.length, 2 * projectile.edge_radius,
                     "twice the edge radius");
}

void read_sphere(Section& section, Projectile& projectile) {
    for (const std::string_view key : {"edge_radius", "length"})
        section.refuse_if(section.has(key), key, "none for a sphere");
    projectile.length = projectile.diameter;
}

/// `length` of a projectile whose nose is so long.
void read_length(Section& section, Projectile& projectile, double nose) {
    projectile.length = section.quantity("length", length, positive);
    require_at_least(section, "length", projectile.length, nose, "the length of the nose");
}

/// Length of a nose that tapers by `drop` in radius: `nose_length`, or the `apex_angle` between its sides.
double read_taper(Section& section, double drop) {
    const bool by_angle = section.has("apex_angle");
    if (!by_angle) return section.quantity("nose_length", length, positive);
    section.refuse_if(section.has("nose_length"), "nose_length", "none beside apex_angle, which gives it");
    constexpr Range below_flat{0, false, 179 * std::numbers::pi / 180,
                               " greater than 0 and of at most 179 deg", "'60 deg'"};
    return drop / tangent(section.quantity("apex_angle", angle, below_flat) / 2);
}

void read_cone(Section& section, Projectile& projectile) {
    const double radius = projectile.diameter / 2;
    projectile.nose_length = read_taper(section, radius);
    projectile.tip_radius = section.quantity("tip_radius", length, non_negative, 0);
    // The largest sphere touches the cone at its base.
    const double slope = radius / projectile.nose_length, sine = slope / length_of(1, slope),
                 cosine_of_taper = 1 / length_of(1, slope);
    require_at_most(section, "tip_radius", projectile.tip_radius, radius / cosine_of_taper,
                    "that of the sphere that touches the cone at its base");
    read_length(section, projectile, projectile.nose_length - projectile.tip_radius * (1 / sine - 1));
}

void read_truncated_cone(Section& section, Projectile& projectile) {
    projectile.tip_diameter = section.quantity("tip_diameter", length, positive);
    section.refuse_if(projectile.tip_diameter >= projectile.diameter, "tip_diameter",
                      "less than the diameter");
    projectile.nose_length = read_taper(section, (projectile.diameter - projectile.tip_diameter) / 2);
    read_length(section, projectile, projectile.nose_length);
}

void read_ogive(Section& section, Projectile& projectile) {
    constexpr Range tangent{0.5, true, 1000, " from 0.5, a hemisphere, to 1000", "'3'"};
    projectile.caliber_radius_head = section.quantity("caliber_radius_head", ratio, tangent);
    projectile.tip_radius = section.quantity("tip_radius", length, non_negative, 0);
    const double d = projectile.diameter, arc = projectile.caliber_radius_head * d,
                 tip = projectile.tip_radius;
    require_at_most(section, "tip_radius", tip, d / 2, "half the diameter");
    const double nose = std::sqrt(std::max((arc - tip) * (arc - tip) - (arc - d / 2) * (arc - d / 2), 0.0));
    read_length(section, projectile, nose + tip);
}

/// Extent of points along an axis.
template <class Points>
std::pair<double, double> extent(const Points& points, std::size_t axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& point : points) low = std::min(low, point[axis]), high = std::max(high, point[axis]);
    return {low, high};
}

void read_profile(Section& section, Projectile& projectile) {
    projectile.profile = profile_points(section);
    if (projectile.profile.empty()) return;
    projectile.diameter = 2 * extent(projectile.profile, 0).second;
    const auto [rear, front] = extent(projectile.profile, 1);
    projectile.length = front - rear;
}

void read_box(Section& section, Projectile& projectile) {
    projectile.size = section.vector<3>("size", length, positive);
    projectile.diameter = length_of(projectile.size[0], projectile.size[1]);
    projectile.length = projectile.size[2];
}

void read_ring_segment(Section& section, Projectile& projectile) {
    constexpr Range below_half_turn{0, false, 170 * std::numbers::pi / 180,
                                    " greater than 0 and of at most 170 deg", "'30 deg'"};
    projectile.outer_radius = section.quantity("outer_radius", length, positive);
    projectile.thickness = section.quantity("thickness", length, positive);
    projectile.width = section.quantity("width", length, positive);
    projectile.sector = section.quantity("sector", angle, below_half_turn);
    section.refuse_if(projectile.thickness >= projectile.outer_radius, "thickness",
                      "less than the outer radius");
    const double half = projectile.sector / 2, inner = projectile.outer_radius - projectile.thickness;
    projectile.diameter = length_of(2 * projectile.outer_radius * sine(half), projectile.width);
    projectile.length = projectile.outer_radius - inner * cosine(half);
}

void read_fsp(Section& section, Projectile& projectile) {
    projectile.flat_width = section.quantity("flat_width", length, positive);
    section.refuse_if(projectile.flat_width >= projectile.diameter, "flat_width", "less than the diameter");
    constexpr Range slanted{0, false, 80 * std::numbers::pi / 180, " greater than 0 and of at most 80 deg",
                            "'35 deg'"};
    projectile.flat_angle = section.quantity("flat_angle", angle, slanted, 35 * std::numbers::pi / 180);
    read_length(section, projectile,
                (projectile.diameter - projectile.flat_width) / 2 * tangent(projectile.flat_angle));
}

void read_mesh(Section& section, Projectile& projectile) {
    projectile.triangles = mesh_triangles(section);
    if (projectile.triangles.points.empty()) return;
    double radius = 0;
    for (const auto& point : projectile.triangles.points)
        radius = std::max(radius, length_of(point[0], point[1]));
    projectile.diameter = 2 * radius;
    const auto [rear, front] = extent(projectile.triangles.points, 2);
    projectile.length = front - rear;
}

/// Whether the scene states the diameter of a shape.
bool has_diameter(Shape shape) {
    return shape != Shape::profile && shape != Shape::box && shape != Shape::ring_segment &&
           shape != Shape::mesh;
}

}  // namespace

std::string_view shape_name(Shape shape) { return name_of(shape, shape_names); }

void read_shape(Section& section, Projectile& projectile) {
    projectile.shape = section.choice("shape", shape_names);
    if (has_diameter(projectile.shape)) projectile.diameter = section.quantity("diameter", length, positive);
    projectile.mass = section.quantity("mass", mass, positive);
    switch (projectile.shape) {
        case Shape::sphere:
            return read_sphere(section, projectile);
        case Shape::cylinder:
            return read_cylinder(section, projectile);
        case Shape::hemisphere:
            return read_length(section, projectile, projectile.diameter / 2);
        case Shape::cone:
            return read_cone(section, projectile);
        case Shape::truncated_cone:
            return read_truncated_cone(section, projectile);
        case Shape::ogive:
            return read_ogive(section, projectile);
        case Shape::profile:
            return read_profile(section, projectile);
        case Shape::box:
            return read_box(section, projectile);
        case Shape::ring_segment:
            return read_ring_segment(section, projectile);
        case Shape::fsp:
            return read_fsp(section, projectile);
        case Shape::mesh:
            return read_mesh(section, projectile);
    }
}

}  // namespace weavefront::scene
