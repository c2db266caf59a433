#pragma once
/// @file
/// Facets of other ranks that contact needs.

#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/whereabouts.hpp"
#include "weavefront/parallel/exchange.hpp"
#include "weavefront/partition/halo_plan.hpp"
#include "weavefront/solver/nodes.hpp"

namespace weavefront::solver {

/// The one exchange of a step: what each rank adds to the force of a node goes to all ranks that know the node, as their own or as a
/// ghost. All of them then move it alike, so that positions need not travel.
using ForceExchange = parallel::Exchange<FixedVector>;

/// Over the nodes that ranks share, without ghosts.
ForceExchange halo_exchange(const partition::HaloPlan& plan);

/// Rebuilds the ghost layer: the facets of other ranks that are not eroded and whose footprint comes within `reach` of that of one of this
/// rank's, in any ply, and some around them: what lies over one cell of the mesh is looked at as one. Facets that share a node with this
/// rank's are among them, so its nodal normals are complete.
/// @param expected where this rank's nodes are until the next rebuild
/// @param reach    distance up to which facets may matter until then, m
/// @param surface  owned facets stand, with their rims; ghosts are replaced
/// @param nodes    ghosts are replaced by the new ones, complete but for the force
/// @return         the exchange over shared nodes and ghosts
/// @note Collective
ForceExchange rebuild_ghosts(const parallel::Communicator& comm, const partition::HaloPlan& plan, const contact::Whereabouts& expected,
                             double reach, contact::Surface& surface, Nodes& nodes);

}  // namespace weavefront::solver
