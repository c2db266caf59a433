#include "weavefront/solver/model.hpp"

#include <algorithm>
#include <utility>

#include "weavefront/mesh/part.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/partition/run_decomposition.hpp"

namespace weavefront::solver {

namespace {

std::array<Vec3, 4> corners_of(const mesh::Part& part, std::size_t element) {
    std::array<Vec3, 4> corners;
    for (std::size_t a = 0; a < 4; ++a)
        corners[a] = part.positions[static_cast<std::size_t>(part.element_nodes[element][a])];
    return corners;
}

InitialPositions initial_positions(const mesh::Panel& panel, const std::vector<Vec3>& positions) {
    InitialPositions initial;
    const auto of_ply = positions.size() / panel.plies.size();
    initial.in_plane.one_ply.reserve(of_ply);
    for (std::size_t n = 0; n < of_ply; ++n)
        initial.in_plane.one_ply.push_back({positions[n].x(), positions[n].y()});
    for (const auto& ply : panel.plies) initial.heights.push_back(ply.z);
    return initial;
}

Nodes build_nodes(const mesh::Panel& panel, const mesh::Part& part, const std::vector<bool>& owned) {
    Nodes nodes;
    nodes.count = static_cast<std::int32_t>(part.node_ids.size());
    nodes.ids = part.node_ids;
    nodes.owned = owned;
    nodes.x = part.positions;
    nodes.initial = initial_positions(panel, part.positions);
    nodes.v.assign(part.positions.size(), Vec3::Zero());
    nodes.supports = part.supports;
    nodes.force.resize(part.positions.size());
    return nodes;
}

/// A quarter of each element's mass on each of its nodes, summed as integers over the ranks.
void lump_mass(const scene::Scene& scene, const mesh::Panel& panel, const mesh::Part& part,
               const std::vector<double>& areas, const parallel::Communicator& comm, Model& model) {
    double largest = 0;
    std::vector<double> quarter;
    for (std::size_t e = 0; e < areas.size(); ++e) {
        const auto& ply = panel.plies[static_cast<std::size_t>(part.element_plies[e])];
        quarter.push_back(scene.fabrics[static_cast<std::size_t>(ply.fabric)].areal_density * areas[e] / 4);
        largest = std::max(largest, quarter.back());
    }
    const parallel::FixedPoint scale(comm.max(largest));
    std::vector<FixedVector> sums(part.node_ids.size());
    for (std::size_t e = 0; e < areas.size(); ++e)
        for (const auto node : part.element_nodes[e])
            sums[static_cast<std::size_t>(node)][0] += scale.from(quarter[e]);
    halo_exchange(model.halo).sum(comm, sums);
    model.nodes.mass.reserve(sums.size());
    for (const auto& sum : sums) model.nodes.mass.push_back(scale.to(sum[0]));
}

/// Of each ply; empty where its yarns are equally strong.
std::vector<std::optional<shell::ScatteredStrength>> scattered_strengths(const scene::Scene& scene,
                                                                         const mesh::Panel& panel) {
    std::vector<std::optional<shell::ScatteredStrength>> strengths(panel.plies.size());
    for (std::size_t p = 0; p < panel.plies.size(); ++p) {
        const auto& fabric = scene.fabrics[static_cast<std::size_t>(panel.plies[p].fabric)];
        if (fabric.failure && fabric.failure->scatter)
            strengths[p].emplace(fabric, static_cast<std::int32_t>(p), panel.plies[p].angle);
    }
    return strengths;
}

void build_groups(const scene::Scene& scene, const mesh::Panel& panel, const mesh::Part& part, Model& model) {
    std::vector<std::vector<shell::GroupElement>> by_fabric(scene.fabrics.size());
    std::vector<std::int32_t> group_of(scene.fabrics.size(), -1);
    const auto strengths = scattered_strengths(scene, panel);
    for (std::size_t e = 0; e < part.element_ids.size(); ++e) {
        const auto p = static_cast<std::size_t>(part.element_plies[e]);
        const auto& ply = panel.plies[p];
        const auto corners = corners_of(part, e);
        by_fabric[static_cast<std::size_t>(ply.fabric)].push_back(
            {static_cast<std::int32_t>(e), part.element_nodes[e], shell::make_quad(corners, ply.angle),
             strengths[p] ? strengths[p]->of(corners) : shell::RelativeStrength{}});
    }
    for (std::size_t f = 0; f < by_fabric.size(); ++f) {
        if (by_fabric[f].empty()) continue;
        group_of[f] = static_cast<std::int32_t>(model.groups.size());
        model.groups.push_back(shell::make_element_group(scene.fabrics[f], by_fabric[f]));
    }
    const auto of_ply = static_cast<std::int32_t>(part.element_ids.size() / panel.plies.size());
    std::vector<std::int32_t> placed(scene.fabrics.size(), 0);
    for (const auto& ply : panel.plies) {
        const auto f = static_cast<std::size_t>(ply.fabric);
        model.slots.append(of_ply, {group_of[f], placed[f]});
        placed[f] += of_ply;
    }
}

void build_surface(const scene::Scene& scene, const mesh::Panel& panel, const mesh::Part& part,
                   const std::vector<double>& areas, contact::Surface& surface) {
    surface.facets.reserve(part.element_ids.size());
    for (std::size_t e = 0; e < part.element_ids.size(); ++e)
        surface.facets.push_back({part.element_ids[e], part.element_nodes[e], part.element_plies[e]});
    surface.alive.assign(part.element_ids.size(), 1);
    surface.owned = static_cast<std::int32_t>(part.element_ids.size());
    surface.areas.one_ply.assign(
        areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / panel.plies.size()));
    surface.symmetry = panel.symmetry;
    for (const auto& ply : panel.plies) {
        const auto& fabric = scene.fabrics[static_cast<std::size_t>(ply.fabric)];
        surface.plies.push_back({ply.z, fabric.contact_thickness, fabric.areal_density});
    }
}

/// The force that strains the stiffest yarns of the largest element by a tenth, or presses contact
/// through its thickness.
double largest_force(const scene::Scene& scene) {
    const auto& target = *scene.target;
    double largest = 0;
    for (const auto& fabric : scene.fabrics) {
        double membrane = 0;
        for (const auto& system : fabric.systems())
            membrane = std::max(membrane, 0.1 * system.elastic.hooke_modulus * system.yarn.area /
                                              system.spacing * target.mesh.edge);
        const double pressed = target.mesh.edge * target.mesh.edge * fabric.contact_thickness;
        largest = std::max({largest, membrane,
                            scene.contact.projectile ? scene.contact.projectile->stiffness * pressed : 0.0,
                            scene.contact.plies ? scene.contact.plies->stiffness * pressed : 0.0,
                            target.frame ? scene.contact.frame.stiffness * pressed : 0.0});
    }
    return largest;
}

/// Friction of the nodes of a part in clamps. @pre mass and part of the model are there
void build_clamps(const scene::Scene& scene, const mesh::Panel& panel, const mesh::Part& part, Model& model) {
    const auto& clamps = scene.target->clamps;
    if (!clamps[0] && !clamps[1]) return;
    const auto plies = panel.plies.size(), of_ply = part.node_ids.size() / plies;
    std::vector<contact::ClampFriction::Column> columns;
    for (std::size_t n = 0; n < of_ply; ++n) {
        const auto clamp = panel.clamp_of(part.node_ids[n]);
        if (!clamp) continue;
        contact::ClampFriction::Column column{n, *clamp, {}};
        for (std::size_t p = 0; p < plies; ++p)
            column.area.push_back(model.nodes.mass[n + p * of_ply] / model.surface.plies[p].areal_density);
        columns.push_back(std::move(column));
    }
    model.clamp_friction.emplace(clamps, scene.contact.frame.stiffness, std::move(columns), of_ply, plies);
}

void build_projectiles(const scene::Scene& scene, Model& model) {
    double arm = 0;
    for (const auto& p : scene.projectiles) {
        auto projectile = make_projectile(p);
        arm = std::max(arm, projectile.arm);
        projectile.contact_name = name_of_projectile(model.projectiles.size()) + "_contact";
        if (scene.contact.projectile) {
            projectile.contact.emplace(projectile.shape, projectile.body, *scene.contact.projectile,
                                       scene.contact.spacing, model.surface, model.nodes.x,
                                       static_cast<std::uint16_t>(model.projectiles.size()));
            const auto& last = model.surface.plies.back();
            if (scene.target->frame)
                projectile.on_frame.emplace(p, *scene.target->frame, *scene.contact.projectile,
                                            last.z + last.thickness / 2);
        }
        model.projectiles.push_back(std::move(projectile));
    }
    model.assembly = Assembly(largest_force(scene), arm);
}

}  // namespace

bool Model::touches(std::int32_t element) const {
    return (ply_contact && ply_contact->touches(element)) ||
           std::ranges::any_of(projectiles, [&](const auto& projectile) {
               return projectile.contact && projectile.contact->touches(element);
           });
}

shell::ElementOutput Model::output(std::int32_t element) const {
    if (const auto held = eroded.find(element); held != eroded.end()) return held->second;
    const auto slot = slots[static_cast<std::size_t>(element)];
    return groups[static_cast<std::size_t>(slot.group)]->output(slot.index, nodes.x);
}

std::size_t Model::bytes() const {
    std::size_t sum =
        nodes.x.size() * (2 * sizeof(Vec3) + sizeof(FixedVector) + sizeof(double) + sizeof(std::int64_t) + 1);
    for (const auto& group : groups) sum += group->bytes();
    return sum + surface.facets.size() * (sizeof(contact::Facet) + 1);
}

partition::Decomposition initial_decomposition(const scene::Scene& scene, const mesh::Panel& panel,
                                               double ghost_reach, const parallel::Communicator& comm) {
    partition::Decomposition decomposition{comm.size(), {}};
    if (comm.size() > panel.columns())
        return partition::decompose(panel, {}, comm.size());  // throws on every rank
    parallel::on_root(
        comm, [&] { decomposition = partition::decompose_for_run(scene, panel, comm.size(), ghost_reach); });
    comm.broadcast(decomposition.owner);
    return decomposition;
}

Model build_model(const scene::Scene& scene, const mesh::Panel& panel,
                  const partition::Decomposition& decomposition, const parallel::Communicator& comm) {
    const auto part = mesh::make_part(panel, decomposition.columns_of(comm.rank()));
    Model model;
    model.halo = partition::make_halo_plan(panel, decomposition, part, comm.rank());
    model.nodes = build_nodes(panel, part, model.halo.owned);
    model.global = {panel.nodes(), panel.elements(), part.element_ids};
    model.smallest_edge = panel.smallest_edge();
    build_groups(scene, panel, part, model);
    std::vector<double> areas;
    for (std::size_t e = 0; e < part.element_ids.size(); ++e)
        areas.push_back(shell::make_quad(corners_of(part, e), 0).area);
    lump_mass(scene, panel, part, areas, comm, model);
    build_surface(scene, panel, part, areas, model.surface);
    model.exchange = halo_exchange(model.halo);
    build_projectiles(scene, model);
    if (scene.contact.plies && panel.plies.size() > 1)
        model.ply_contact.emplace(*scene.contact.plies, scene.contact.spacing, model.surface, model.nodes.x);
    if (scene.target->frame)
        model.frame_contact.emplace(*scene.target->frame, scene.contact.frame, scene.contact.spacing,
                                    model.surface, model.nodes.x);
    build_clamps(scene, panel, part, model);
    return model;
}

}  // namespace weavefront::solver
