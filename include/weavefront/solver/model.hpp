#pragma once
/// @file
/// Everything that one rank computes with.

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "weavefront/contact/clamp_friction.hpp"
#include "weavefront/contact/frame_contact.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/ply_contact.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/partition/decomposition.hpp"
#include "weavefront/partition/halo_plan.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/shell/element_group.hpp"
#include "weavefront/solver/assembly.hpp"
#include "weavefront/solver/element_slots.hpp"
#include "weavefront/solver/ghosts.hpp"
#include "weavefront/solver/nodes.hpp"
#include "weavefront/solver/projectile.hpp"

namespace weavefront::solver {

/// The global size and the ids by which results are ordered.
struct GlobalIds {
    std::int64_t nodes = 0, elements = 0;
    std::vector<std::int64_t> element_ids;  ///< of the owned elements, ascending
};

/// What a scene does not ask for is an empty list or an empty optional here.
struct Model {
    Nodes nodes;
    std::vector<std::unique_ptr<shell::ElementGroup>> groups;  ///< one a fabric
    ElementSlots slots;                                        ///< of the owned elements
    contact::Surface surface;
    contact::NodalNormals normals;  ///< of the plies, for contact
    partition::HaloPlan halo;
    Ghosts ghosts;
    ForceExchange exchange;
    Assembly assembly;
    GlobalIds global;
    double smallest_edge = 0;  ///< of all elements, m
    std::vector<Projectile> projectiles;
    std::optional<contact::PlyContact> ply_contact;
    std::optional<contact::FrameContact> frame_contact;
    std::optional<contact::ClampFriction> clamp_friction;
    /// What results show of owned elements that are eroded, as it was when that happened: their strains go on
    /// growing with their nodes.
    std::unordered_map<std::int32_t, shell::ElementOutput> eroded;

    /// Whether projectiles meet the fabric.
    [[nodiscard]] bool has_projectile_contact() const {
        return !projectiles.empty() && projectiles.front().contact;
    }
    /// Whether contact remembers anything of an owned element: it touches another ply or a projectile.
    [[nodiscard]] bool touches(std::int32_t element) const;
    /// What results show of an owned element.
    [[nodiscard]] shell::ElementOutput output(std::int32_t element) const;
    [[nodiscard]] std::size_t bytes() const;
};

/// The decomposition that the scene alone suggests, computed on rank 0.
/// @param ghost_reach as for `Ghosts`, m; 0: no ghosts
/// @throws std::invalid_argument when there are more ranks than columns
/// @note Collective
partition::Decomposition initial_decomposition(const scene::Scene& scene, const mesh::Panel& panel,
                                               double ghost_reach, const parallel::Communicator& comm);

/// This rank's part of the target, at rest. @note Collective
Model build_model(const scene::Scene& scene, const mesh::Panel& panel,
                  const partition::Decomposition& decomposition, const parallel::Communicator& comm);

}  // namespace weavefront::solver
