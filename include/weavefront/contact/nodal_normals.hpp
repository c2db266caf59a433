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

/// Normals of nodes: area-weighted means over the facets around them, computed on demand. The facets around a
/// node are added in global order, so every rank that knows them gets the same bits.
class NodalNormals {
  public:
    /// Finds the facets around each node. @param nodes number of local nodes, ghosts included
    void rebuild(const Surface& surface, std::size_t nodes);

    /// Drops all normals, since positions have changed.
    void invalidate() { computed_.clear(); }

    /// Normals at the corners of a facet, as `at` returns them. @param x present positions, m
    std::array<Vec3, 4> of(const Facet& facet, const Surface& surface, std::span<const Vec3> x) {
        const auto& [a, b, c, d] = facet.nodes;
        return {at(a, surface, x), at(b, surface, x), at(c, surface, x), at(d, surface, x)};
    }

    /// Area-weighted normal of a node, not normalised, m2. Eroded facets do not count. @param x present
    /// positions, m
    Vec3 at(std::int32_t node, const Surface& surface, std::span<const Vec3> x);

  private:
    FacetLists around_;  ///< by node: facets around it, ascending global ids
    struct Computed {
        Vec3 normal;
        std::int32_t node;
    };
    std::vector<Computed> computed_;  ///< for the present positions
    std::vector<std::int32_t>
        slots_;  ///< by node: index in computed_; valid only if that entry is of the node
};

}  // namespace weavefront::contact
