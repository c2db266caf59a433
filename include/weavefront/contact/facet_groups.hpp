#pragma once
/// @file
/// Groups of neighbouring facets.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"
#include "weavefront/mesh/adjacency_list.hpp"

namespace weavefront::contact {

/// Patches of at most 16 neighbouring facets, each of one ply.
class FacetGroups {
  public:
    /// Appends the groups of the facets [first, end). They replace all earlier groups of facets from `first`
    /// on.
    /// @param x positions that define the neighbourhood, m
    void group(const Surface& surface, std::span<const Vec3> x, std::int32_t first, std::int32_t end);

    /// Number of groups.
    [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(facets_.rows()); }
    /// Local indices of the facets of a group.
    [[nodiscard]] std::span<const std::int32_t> facets(std::int32_t group) const { return facets_[group]; }
    /// Number of facets in all groups before this one.
    [[nodiscard]] std::size_t before(std::int32_t group) const {
        return static_cast<std::size_t>(facets_.offsets()[static_cast<std::size_t>(group)]);
    }
    /// Local nodes of the facets of a group, each once, ascending.
    [[nodiscard]] std::span<const std::int32_t> nodes(std::int32_t group) const { return nodes_[group]; }

  private:
    void split(const Surface& surface, const std::vector<Vec3>& centres, std::span<std::int32_t> facets);

    mesh::AdjacencyList<std::int32_t> facets_, nodes_;  ///< by group
};

}  // namespace weavefront::contact
