#pragma once
/// @file
/// Facets of other ranks that contact needs.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/swept_bounds.hpp"
#include "weavefront/parallel/exchange.hpp"
#include "weavefront/partition/halo_plan.hpp"
#include "weavefront/solver/nodes.hpp"

namespace weavefront::solver {

/// The one exchange of a step: what each rank adds to the force of a node goes to all ranks that know the
/// node, as their own or as a ghost. All of them then move it alike, so that positions need not travel.
using ForceExchange = parallel::Exchange<FixedVector>;

/// Over the nodes that ranks list, without ghosts.
ForceExchange halo_exchange(const partition::HaloPlan& plan);

/// A facet of this rank that another one knows.
struct GhostFacet {
    std::int32_t facet;
    bool on_free_edge;
};

/// The ghost layer: the facets of other ranks that are not eroded and whose footprint comes within reach of
/// that of one of this rank's, in any ply, and some around them: what lies over one cell of the mesh is
/// looked at as one. Facets that list a node with this rank's are among them, so its nodal normals are
/// complete.
class Ghosts {
  public:
    /// Replaces all ghosts where on any rank one is missing that may matter until the next renewal, or one
    /// has eroded or come to lie on a free edge. Otherwise they stay: every rank moves them as their owner
    /// does.
    /// @param expected where this rank's nodes are until the next renewal
    /// @param reach    within which ghosts are taken in, m
    /// @param spare    part of it that is for later: facets within reach - spare may matter until the next
    /// renewal, m
    /// @param surface  owned facets stand, with their rims; ghosts are replaced
    /// @param nodes    ghosts are replaced by the new ones, complete but for the force
    /// @param exchange replaced by that over shared nodes and ghosts
    /// @return whether they were replaced, the same on all ranks; always the first time
    /// @note Collective
    bool renew(const parallel::Communicator& comm, const partition::HaloPlan& plan,
               const contact::SweptBounds& swept, double reach, double spare, contact::Surface& surface,
               Nodes& nodes, ForceExchange& exchange);

  private:
    [[nodiscard]] static bool suffice(std::span<const GhostFacet> needed, std::span<const GhostFacet> known,
                                      const contact::Surface& surface);

    std::vector<std::vector<GhostFacet>> known_;  ///< of this rank's facets, by the rank that knows them
};

}  // namespace weavefront::solver
