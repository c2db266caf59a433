#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parts.hpp"

namespace weavefront::scene {
namespace {

constexpr double most_nodes = 2147483647;  // of a ply: partitions are numbered with 32 bits

PanelMesh read_mesh(Section& section) {
    PanelMesh mesh;
    mesh.center = section.quantity("center", length, positive);
    mesh.edge = section.quantity("edge", length, positive, mesh.center);
    mesh.growth = section.quantity("growth", ratio, at_least_one, 1.08);
    section.refuse_if(mesh.center > mesh.edge, "center",
                      fmt::format("at most {}, the element size at the edge",
                                  at_most_text(mesh.edge, section.unit_of("center", length))));
    section.unavailable({"file", "type", "radial", "import"});
    return mesh;
}

// Elements over a distance, by the sum of the geometric series of their sizes.
double elements_over(double distance, const PanelMesh& mesh) {
    if (mesh.growth == 1 || mesh.edge == mesh.center) return distance / mesh.center;
    const double growing = std::log(mesh.edge / mesh.center) / std::log(mesh.growth);
    const double covered = (mesh.edge - mesh.center) / (mesh.growth - 1);
    if (distance <= covered)
        return std::log1p(distance * (mesh.growth - 1) / mesh.center) / std::log(mesh.growth);
    return growing + (distance - covered) / mesh.edge;
}

double nodes_of_ply(const Target& target) {
    double nodes = 1;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double halves = target.symmetry[axis] ? 1 : 2;
        nodes *= 1 + halves * elements_over(target.size[axis] / 2, target.mesh);
    }
    return nodes;
}

}  // namespace

Target read_target(Section& section, std::span<const Fabric> fabrics) {
    Target target;
    target.size = section.vector<2>("size", length, positive);
    for (const std::size_t axis : section.choices("symmetry", axis_names, {})) target.symmetry[axis] = true;
    target.plies = read_plies(section, fabrics, target.symmetry);
    read_supports(section, target);

    const double half = std::min(target.size[0], target.size[1]) / 2;
    target.mesh = section.required("mesh", [&](Section& mesh_section) {
        PanelMesh mesh = read_mesh(mesh_section);
        mesh_section.refuse_if(mesh.center > half, "center",
                               fmt::format("at most {}, half of the target",
                                           at_most_text(half, mesh_section.unit_of("center", length))));
        return mesh;
    });
    const double nodes = nodes_of_ply(target);
    if (nodes > most_nodes)
        section.refuse("mesh", fmt::format("sizes that give {:.3g} nodes a ply", nodes),
                       fmt::format("at most {:.0f}", most_nodes));
    section.unavailable({"file"});
    return target;
}

}  // namespace weavefront::scene
