#include "frames.hpp"

#include <algorithm>
#include <span>

namespace weavefront::app {

namespace {

/// The local indices of the nodes that this rank owns.
std::vector<std::size_t> owned_nodes(const solver::Nodes& nodes) {
    std::vector<std::size_t> owned;
    for (std::size_t n = 0; n < static_cast<std::size_t>(nodes.count); ++n)
        if (nodes.owned[n]) owned.push_back(n);
    return owned;
}

struct CellField {
    scene::Field field;
    const char* name;
    bool integer;
    double (*value)(const shell::ElementOutput&);
};

const std::vector<CellField>& cell_fields() {
    using scene::Field;
    using Output = const shell::ElementOutput&;
    static const std::vector<CellField> fields{
        {Field::strain, "strain_fill", false, [](Output o) { return o.strain_fill; }},
        {Field::strain, "strain_warp", false, [](Output o) { return o.strain_warp; }},
        {Field::stress, "stress_fill", false, [](Output o) { return o.stress_fill; }},
        {Field::stress, "stress_warp", false, [](Output o) { return o.stress_warp; }},
        {Field::braid_angle, "braid_angle", false, [](Output o) { return o.braid_angle; }},
        {Field::crimp, "crimp_height", false, [](Output o) { return o.crimp_height; }},
        {Field::broken, "broken_fill", true, [](Output o) { return o.broken_fill ? 1.0 : 0.0; }},
        {Field::broken, "broken_warp", true, [](Output o) { return o.broken_warp ? 1.0 : 0.0; }},
    };
    return fields;
}

bool wanted(const std::vector<scene::Field>& fields, scene::Field field) {
    return std::find(fields.begin(), fields.end(), field) != fields.end();
}

/// Of the points of the projectiles' surfaces, xyz xyz ...
struct SurfaceMotion {
    std::vector<double> points, displacements, velocities;  ///< m, m, m/s
};

/// @param points of the projectile's surface, in its axes, m
void append_motion(const solver::Simulation& simulation, std::size_t number,
                   std::span<const std::array<double, 3>> points, SurfaceMotion& all) {
    const auto& projectile = simulation.model().projectiles[number].body;
    const auto& initial = simulation.shots()[number].initial;
    body::Motion motion{projectile.centre(), simulation.projectile_velocity(number), {0, 0, 0}};
    if (projectile.turns()) motion.angular_velocity = simulation.projectile_angular_velocity(number);
    const auto append = [](std::vector<double>& values, const Vec3& vector) {
        values.insert(values.end(), {vector.x(), vector.y(), vector.z()});
    };
    for (const auto& [x, y, z] : points) {
        const Vec3 turned = projectile.attitude().to_space({x, y, z}), point = turned + projectile.position();
        append(all.points, point);
        append(all.displacements, (projectile.position() - initial.position()) +
                                      (turned - initial.attitude().to_space({x, y, z})));
        append(all.velocities, motion.at(point));
    }
}

SurfaceMotion surface_motion(const solver::Simulation& simulation, const ProjectileSurfaces& surfaces) {
    SurfaceMotion all;
    std::span<const std::array<double, 3>> rest = surfaces.all.points;
    for (std::size_t p = 0; p < surfaces.points.size(); ++p) {
        append_motion(simulation, p, rest.first(surfaces.points[p]), all);
        rest = rest.subspan(surfaces.points[p]);
    }
    return all;
}

/// Which of several projectiles a quad belongs to, 1 = the first; 0: it is fabric.
io::Array numbers_of_projectiles(const ProjectileSurfaces& surfaces, std::size_t elements) {
    io::Array numbers{"projectile", 1, false, std::vector<double>(elements), {}};
    for (std::size_t p = 0; p < surfaces.quads.size(); ++p)
        numbers.projectile.insert(numbers.projectile.end(), surfaces.quads[p], static_cast<double>(p + 1));
    return numbers;
}

}  // namespace

io::Topology topology_of(const solver::Simulation& simulation) {
    const auto& model = simulation.model();
    io::Topology topology{model.global.nodes, model.global.elements, {}, model.global.element_ids, {}, {}};
    for (const auto n : owned_nodes(model.nodes)) topology.owned_nodes.push_back(model.nodes.ids[n]);
    for (std::size_t e = 0; e < model.global.element_ids.size(); ++e) {
        const auto& facet = model.surface.facets[e];
        std::array<std::int64_t, 4> corners{};
        for (std::size_t a = 0; a < 4; ++a)
            corners[a] = model.nodes.ids[static_cast<std::size_t>(facet.nodes[a])];
        topology.connectivity.push_back(corners);
        topology.ply.push_back(facet.ply + 1);
    }
    return topology;
}

io::Frame frame_of(solver::Simulation& simulation, const ProjectileSurfaces& surfaces,
                   const std::vector<scene::Field>& fields) {
    const auto& fabric = simulation.joined_fabric();
    const auto& model = std::as_const(simulation).model();
    const auto& nodes = model.nodes;
    const auto owned = owned_nodes(nodes);
    io::Frame frame;
    frame.time = simulation.time();
    const auto vectors = [&](auto value) {
        std::vector<double> values(3 * owned.size());
        for (std::size_t i = 0; i < owned.size(); ++i) {
            const Vec3 vector = value(owned[i]);
            for (std::size_t d = 0; d < 3; ++d) values[3 * i + d] = vector[static_cast<Eigen::Index>(d)];
        }
        return values;
    };
    frame.points = vectors([&](std::size_t n) { return nodes.x[n]; });
    const auto of_surface = surface_motion(simulation, surfaces);
    frame.projectile = of_surface.points;
    if (wanted(fields, scene::Field::displacement))
        frame.point_data.push_back({"displacement", 3, false, vectors([&](std::size_t n) -> Vec3 {
                                        return nodes.x[n] - nodes.initial[n];
                                    }),
                                    of_surface.displacements});
    if (wanted(fields, scene::Field::velocity))
        frame.point_data.push_back({"velocity", 3, false,
                                    vectors([&](std::size_t n) { return simulation.velocity(n); }),
                                    of_surface.velocities});

    std::vector<CellField> cells;
    for (const auto& field : cell_fields())
        if (wanted(fields, field.field)) cells.push_back(field);
    const auto elements = model.slots.size();
    for (const auto& field : cells)
        frame.cell_data.push_back({field.name, 1, field.integer, std::vector<double>(elements), {}});
    io::Array joined{"joined", 1, true, std::vector<double>(elements), {}};
    frame.eroded.reserve(elements);
    for (std::size_t e = 0; e < elements; ++e) {
        joined.values[e] = fabric.has_element(model, e) ? 1 : 0;
        const auto slot = model.slots[e];
        frame.eroded.push_back(!model.groups[static_cast<std::size_t>(slot.group)]->alive(slot.index));
        if (cells.empty()) continue;
        const auto output = model.output(static_cast<std::int32_t>(e));
        for (std::size_t c = 0; c < cells.size(); ++c) frame.cell_data[c].values[e] = cells[c].value(output);
    }
    frame.cell_data.push_back(std::move(joined));
    if (surfaces.quads.size() > 1) frame.cell_data.push_back(numbers_of_projectiles(surfaces, elements));
    return frame;
}

}  // namespace weavefront::app
