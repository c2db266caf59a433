#include "synthetic_model.hpp"

namespace weavefront::io {

namespace {

constexpr std::int64_t columns = 7, rows = 5, plies = 2;
constexpr std::int64_t nodes = columns * rows * plies;
constexpr std::int64_t elements = (columns - 1) * (rows - 1) * plies;

}  // namespace

Topology SyntheticModel::topology() const {
    Topology topology{.nodes = nodes,
                      .elements = elements,
                      .owned_nodes = {},
                      .owned_elements = {},
                      .connectivity = {},
                      .ply = {}};
    for (std::int64_t id = 0; id < nodes; ++id)
        if (owns(id)) topology.owned_nodes.push_back(id);
    for (std::int64_t id = 0; id < elements; ++id) {
        if (!owns(id)) continue;
        const auto ply = id / (elements / plies);
        const auto cell = id % (elements / plies);
        const auto corner = ply * columns * rows + cell / (columns - 1) * columns + cell % (columns - 1);
        topology.owned_elements.push_back(id);
        topology.connectivity.push_back({corner, corner + 1, corner + columns + 1, corner + columns});
        topology.ply.push_back(static_cast<std::int32_t>(ply + 1));
    }
    return topology;
}

Surface SyntheticModel::surface() const {
    if (!projectile) return {};
    return {.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
            .quads = {{0, 1, 2, 3}, {1, 4, 5, 2}}};
}

Frame SyntheticModel::frame(int k) const {
    const auto shape = topology();
    Frame frame{
        .time = 0.5 * k, .points = {}, .point_data = {}, .cell_data = {}, .eroded = {}, .projectile = {}};
    Array displacement{
        .name = "displacement", .components = 3, .integer = false, .values = {}, .projectile = {}};
    for (const auto& [x, y, z] : surface().points) {
        frame.projectile.insert(frame.projectile.end(), {x, y + 0.25, z - k});
        displacement.projectile.insert(displacement.projectile.end(), {1.0 * k, 2.0 * k, 3.0 * k});
    }
    Array velocity{.name = "velocity", .components = 3, .integer = false, .values = {}, .projectile = {}};
    for (const auto id : shape.owned_nodes) {
        for (int c = 0; c < 3; ++c) {
            const double value = 1000.0 * k + static_cast<double>(id) + 0.25 * c;
            frame.points.push_back(value);
            displacement.values.push_back(value + 0.125);
            velocity.values.push_back(-value);
        }
    }
    Array strain{.name = "strain_fill", .components = 1, .integer = false, .values = {}, .projectile = {}};
    Array broken{.name = "broken_fill", .components = 1, .integer = true, .values = {}, .projectile = {}};
    for (const auto id : shape.owned_elements) {
        strain.values.push_back(k + 0.0625 * static_cast<double>(id));
        broken.values.push_back((id + k) % 3 == 0 ? 1 : 0);
        frame.eroded.push_back((id + k) % 5 == 0);
    }
    frame.point_data = {displacement, velocity};
    frame.cell_data = {strain, broken};
    return frame;
}

ResultsSetup SyntheticModel::setup(const std::filesystem::path& path, int max_frames) const {
    return {.path = path,
            .topology = topology(),
            .surface = surface(),
            .layout = frame(0),
            .max_frames = max_frames,
            .scene = "title: synthetic\n",
            .version = "1.2.3"};
}

}  // namespace weavefront::io
