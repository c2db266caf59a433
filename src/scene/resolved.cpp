#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/emitter.h>

#include <iterator>
#include <sstream>

#include "parts.hpp"

namespace weavefront::scene {
namespace {

// fmt's `{}` is the shortest text that reads back as the same double.
template <typename... Values>
void line(std::string& text, fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
    text += '\n';
}

std::string quoted(const std::string& text) {
    YAML::Emitter emitter;
    emitter << YAML::DoubleQuoted << text;
    return emitter.c_str();
}

/// A value of the yarns with its unit: of fill and warp where they differ.
template <typename Of>
std::string of_yarns(const Fabric& f, std::string_view unit, Of of) {
    const auto [fill, warp] = f.systems();
    if (!f.warp) return fmt::format("{}{}", of(fill), unit);
    return fmt::format("{{fill: {}{}, warp: {}{}}}", of(fill), unit, of(warp), unit);
}

void write_yarns(std::string& text, const Fabric& f) {
    using System = YarnSystem;
    line(text, "    yarn: {{span: {}, area: {}, width: {}}}",
         of_yarns(f, " m", [](const System& of) { return of.yarn.span; }),
         of_yarns(f, " m^2", [](const System& of) { return of.yarn.area; }),
         of_yarns(f, " m", [](const System& of) { return of.yarn.width; }));
    if (f.warp)
        line(text, "    crimp_height: {}",
             of_yarns(f, " m", [](const System& of) { return of.crimp_height; }));
    else
        line(text, "    thickness: {} m", f.thickness);
    line(text, "    elastic: {{static_modulus: {}, hooke_modulus: {}, viscosity: {}}}",
         of_yarns(f, " Pa", [](const System& of) { return of.elastic.static_modulus; }),
         of_yarns(f, " Pa", [](const System& of) { return of.elastic.hooke_modulus; }),
         of_yarns(f, " Pa s", [](const System& of) { return of.elastic.viscosity; }));
    if (!f.failure) return;
    const auto& scatter = f.failure->scatter;
    line(text, "    failure: {{static_strain: {}, hooke_strain: {}, erode: {}{}}}",
         of_yarns(f, "", [](const System& of) { return of.strength->static_strain; }),
         of_yarns(f, "", [](const System& of) { return of.strength->hooke_strain; }),
         name_of(f.failure->erode, erode_names),
         scatter ? fmt::format(", scatter: {{weibull_modulus: {}, gauge_length: {} m, seed: {}}}",
                               scatter->weibull_modulus, scatter->gauge_length, scatter->seed)
                 : "");
}

void write_fabric(std::string& text, const Fabric& f) {
    line(text, "  {}:", quoted(f.name));
    line(text, "    formulation: {}", name_of(f.formulation, formulation_names));
    line(text, "    areal_density: {} kg/m^2", f.areal_density);
    line(text, "    density: {} kg/m^3", f.density);
    write_yarns(text, f);
    if (f.lateral) {
        line(text,
             "    lateral: {{modulus: {} Pa, shear_modulus: {} Pa, locking_angle: {} rad, transition: {} "
             "rad}}",
             f.lateral->modulus, f.lateral->shear_modulus, f.lateral->locking_angle, f.lateral->transition);
    }
    line(text, "    friction: {}", f.friction);
    line(text, "    transverse_shear: {} Pa", f.transverse_shear);
    line(text, "    hourglass: {}", f.hourglass);
    line(text, "    contact_thickness: {} m", f.contact_thickness);
}

std::string friction_text(const Friction& friction) {
    return fmt::format("friction: {{static: {}, kinetic: {}, stiffness_ratio: {}}}",
                       friction.static_coefficient, friction.kinetic_coefficient, friction.stiffness_ratio);
}

std::string edge_text(const Target& target, std::size_t axis) {
    const auto& clamp = target.clamps[axis];
    if (!clamp) return std::string(name_of(target.edges[axis], edge_names));
    return fmt::format("{{clamp: {{pressure: {} Pa, {}}}}}", clamp->pressure, friction_text(clamp->friction));
}

void write_target(std::string& text, const Target& target, const std::vector<Fabric>& fabrics) {
    std::vector<std::string_view> symmetry;
    for (const auto& [name, axis] : axis_names) {
        if (target.symmetry[axis]) symmetry.push_back(name);
    }
    line(text, "target:");
    line(text, "  size: [{} m, {} m]", target.size[0], target.size[1]);
    line(text, "  plies:");
    for (std::size_t i = 0; i < target.plies.size(); ++i) {
        const Ply& ply = target.plies[i];
        const std::string spacing = i == 0 ? "" : fmt::format(", spacing: {} m", ply.spacing);
        const std::string fabric = quoted(fabrics[static_cast<std::size_t>(ply.fabric)].name);
        line(text, "    - {{fabric: {}, angle: {} rad{}}}", fabric, ply.angle, spacing);
    }
    line(text, "  mesh: {{center: {} m, edge: {} m, growth: {}}}", target.mesh.center, target.mesh.edge,
         target.mesh.growth);
    line(text, "  symmetry: [{}]", fmt::join(symmetry, ", "));
    line(text, "  edges: {{x: {}, y: {}}}", edge_text(target, 0), edge_text(target, 1));
    if (target.frame) {
        std::vector<std::string> openings;
        for (const auto& [name, axis] : axis_names) {
            const auto& half = target.frame->half_opening[axis];
            if (half) openings.push_back(fmt::format("{}: {} m", name, 2 * *half));
        }
        if (target.frame->radius)
            openings.push_back(fmt::format("diameter: {} m", 2 * *target.frame->radius));
        line(text, "  frame: {{opening: {{{}}}, edge_radius: {} m}}", fmt::join(openings, ", "),
             target.frame->edge_radius);
    }
}

template <std::size_t N>
void write_points(std::string& text, const std::vector<std::array<double, N>>& points) {
    line(text, "  points:");
    for (const auto& point : points) line(text, "    - [{} m]", fmt::join(point, " m, "));
}

/// The keys of a shape beside `shape`, `mass` and `diameter`.
void write_dimensions(std::string& text, const Projectile& p) {
    switch (p.shape) {
        case Shape::sphere:
            return;
        case Shape::cylinder:
            line(text, "  edge_radius: {} m", p.edge_radius);
            break;
        case Shape::hemisphere:
            break;
        case Shape::cone:
            line(text, "  nose_length: {} m", p.nose_length);
            line(text, "  tip_radius: {} m", p.tip_radius);
            break;
        case Shape::truncated_cone:
            line(text, "  nose_length: {} m", p.nose_length);
            line(text, "  tip_diameter: {} m", p.tip_diameter);
            break;
        case Shape::ogive:
            line(text, "  caliber_radius_head: {}", p.caliber_radius_head);
            line(text, "  tip_radius: {} m", p.tip_radius);
            break;
        case Shape::fsp:
            line(text, "  flat_width: {} m", p.flat_width);
            line(text, "  flat_angle: {} rad", p.flat_angle);
            break;
        case Shape::profile:
            return write_points(text, p.profile);
        case Shape::box:
            return line(text, "  size: [{} m]", fmt::join(p.size, " m, "));
        case Shape::ring_segment:
            line(text, "  outer_radius: {} m", p.outer_radius);
            line(text, "  thickness: {} m", p.thickness);
            line(text, "  width: {} m", p.width);
            return line(text, "  sector: {} rad", p.sector);
        case Shape::mesh:
            write_points(text, p.triangles.points);
            line(text, "  triangles:");
            for (const auto& corners : p.triangles.corners)
                line(text, "    - [{}]", fmt::join(corners, ", "));
            return;
    }
    line(text, "  length: {} m", p.length);
}

void write_projectile(std::string& text, const Projectile& p, const std::array<bool, 2>& symmetry) {
    line(text, "  shape: {}", shape_name(p.shape));
    const bool derived = p.shape == Shape::profile || p.shape == Shape::box ||
                         p.shape == Shape::ring_segment || p.shape == Shape::mesh;
    if (!derived) line(text, "  diameter: {} m", p.diameter);
    write_dimensions(text, p);
    line(text, "  mass: {} kg", p.mass);
    line(text, "  position: [{} m, {} m, {} m]", p.position[0], p.position[1], p.position[2]);
    line(text, "  velocity: [{} m/s, {} m/s, {} m/s]", p.velocity[0], p.velocity[1], p.velocity[2]);
    if (p.delay > 0) line(text, "  delay: {} s", p.delay);
    if (p.attitude != std::array<double, 4>{1, 0, 0, 0})
        line(text, "  orientation: {{quaternion: [{}]}}", fmt::join(p.attitude, ", "));
    if (p.angular_velocity != std::array<double, 3>{0, 0, 0})
        line(text, "  angular_velocity: [{} rad/s]", fmt::join(p.angular_velocity, " rad/s, "));
    if (p.inertia) line(text, "  inertia: [{} kg m^2]", fmt::join(*p.inertia, " kg m^2, "));
    const bool is_held_by_symmetry = symmetry[0] && symmetry[1];
    if (!p.turns && !is_held_by_symmetry) line(text, "  fixed: rotation");
}

void write_projectiles(std::string& text, const std::vector<Projectile>& projectiles,
                       const std::array<bool, 2>& symmetry) {
    if (projectiles.empty()) return;
    if (projectiles.size() == 1) {
        line(text, "projectile:");
        return write_projectile(text, projectiles.front(), symmetry);
    }
    line(text, "projectiles:");
    for (const auto& projectile : projectiles) {
        std::string keys, row;
        write_projectile(keys, projectile, symmetry);
        std::istringstream rows(keys);
        for (std::string_view indent = "  - "; std::getline(rows, row); indent = "    ")
            line(text, "{}{}", indent, row.substr(2));
    }
}

void write_law(std::string& text, std::string_view key, const std::optional<ContactLaw>& law) {
    if (!law) return;
    const auto& friction = law->friction;
    line(text, "  {}: {{stiffness: {} N/m^3, unloading: {}, damping: {}{}}}", key, law->stiffness,
         law->unloading, law->damping, friction ? ", " + friction_text(*friction) : std::string());
}

void write_contact(std::string& text, const Contact& contact, bool has_frame) {
    line(text, "contact:");
    line(text, "  spacing: {}", contact.spacing ? fmt::format("{} m", *contact.spacing) : "nodes");
    write_law(text, "projectile", contact.projectile);
    write_law(text, "plies", contact.plies);
    if (has_frame) write_law(text, "frame", contact.frame);
}

void write_output(std::string& text, const Output& output) {
    std::vector<std::string_view> fields;
    for (const Field field : output.fields) fields.push_back(name_of(field, field_names));
    line(text, "output: {{interval: {} s, history: {} s, fields: [{}]}}", output.interval, output.history,
         fmt::join(fields, ", "));
}

}  // namespace

std::string resolved_text(const Scene& scene) {
    std::string text;
    line(text, "title: {}", quoted(scene.title));
    line(text, "fabrics:");
    for (const Fabric& fabric : scene.fabrics) write_fabric(text, fabric);
    if (scene.target) write_target(text, *scene.target, scene.fabrics);
    write_projectiles(text, scene.projectiles,
                      scene.target ? scene.target->symmetry : std::array{false, false});
    write_contact(text, scene.contact, scene.target && scene.target->frame);
    line(text, "damping: {} 1/s", scene.damping);
    if (scene.time.end > 0)
        line(text, "time: {{end: {} s, safety: {}, stop: {}}}", scene.time.end, scene.time.safety,
             name_of(scene.time.stop, stop_names));
    line(text, "limits: {{energy_error: {}}}", scene.limits.energy_error);
    if (scene.output.history > 0) write_output(text, scene.output);
    return text;
}

}  // namespace weavefront::scene
