#pragma once
/// @file
/// Smoothed normals of the plies.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Normals of nodes as the area-weighted mean over the facets around them, computed when asked for. The
/// facets around a node add up in global order, so that every rank that knows them gets the same bits.
class NodalNormals {
  public:
    /// Finds the facets around each node. @param nodes number of local nodes, ghosts included
    void rebuild(const Surface& surface, std::size_t nodes);

    /// Forgets the normals of the last positions.
    void new_positions() { computed_.clear(); }

    /// Those of the corners of a facet.
    std::array<Vec3, 4> of(const Facet& facet, const Surface& surface, std::span<const Vec3> x) {
        const auto& [a, b, c, d] = facet.nodes;
        return {at(a, surface, x), at(b, surface, x), at(c, surface, x), at(d, surface, x)};
    }

    /// Area-weighted normal, not normalised, m2. Eroded facets do not count.
    Vec3 at(std::int32_t node, const Surface& surface, std::span<const Vec3> x);

  private:
    FacetLists around_;  ///< facets around a node, ascending global ids
    struct Computed {
        Vec3 normal;
        std::int32_t node;
    };
    std::vector<Computed> computed_;   ///< those asked for at these positions
    std::vector<std::int32_t> slots_;  ///< of each node among them, if that one is its own
};

}  // namespace weavefront::contact
