#pragma once
/// @file
/// Facets of other ranks that contact needs.

#include <cstdint>
#include <vector>

#include "weavefront/contact/surface.hpp"
#include "weavefront/parallel/exchange.hpp"
#include "weavefront/partition/halo_plan.hpp"
#include "weavefront/solver/nodes.hpp"

namespace weavefront::solver {

/// What leaves and enters a rank every step: forces of shared and ghost nodes, positions and velocities of ghosts.
struct Links {
    parallel::Exchange<FixedVector> forces;            ///< sums over all ranks that add to a node
    parallel::Exchange<std::array<double, 6>> ghosts;  ///< position and velocity from a rank that holds the node
    std::vector<std::array<double, 6>> values;         ///< what `ghosts` moves, by node
};

/// The links of the halo alone: no ghosts.
Links halo_links(const partition::HaloPlan& plan);

/// Rebuilds the ghost layer: the facets of other ranks whose footprint in x and y comes within `reach` of this rank's own. Facets that
/// share a node with this rank's are among them, so nodal normals are complete.
/// @param surface owned facets stand, ghosts are replaced
/// @param nodes   ghosts are replaced; positions and velocities of the new ones are filled in
/// @param reach   distance up to which facets may matter until the next rebuild, m
/// @return        the links of halo and ghosts
/// @note Collective
Links rebuild_ghosts(const parallel::Communicator& comm, const partition::HaloPlan& plan, double reach, contact::Surface& surface,
                     Nodes& nodes);

/// Brings positions and velocities of the ghosts up to date. @note Collective
void update_ghosts(const parallel::Communicator& comm, Links& links, Nodes& nodes);

}  // namespace weavefront::solver
