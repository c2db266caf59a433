#pragma once
/// @file
/// Groups of neighbouring facets.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Patches of at most 16 neighbouring facets, each of one ply.
class FacetGroups {
  public:
    /// Appends the groups of the facets [first, end). They replace all earlier groups of facets from `first`
    /// on.
    /// @param x positions that define the neighbourhood, m
    void group(const Surface& surface, std::span<const Vec3> x, std::int32_t first, std::int32_t end);

    /// Number of groups.
    [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(first_.size()) - 1; }
    /// Local indices of the facets of a group.
    [[nodiscard]] std::span<const std::int32_t> facets(std::int32_t group) const {
        return within(facets_, first_, group);
    }
    /// Number of facets in all groups before this one.
    [[nodiscard]] std::size_t before(std::int32_t group) const {
        return static_cast<std::size_t>(first_[static_cast<std::size_t>(group)]);
    }
    /// Local nodes of the facets of a group, each once, ascending.
    [[nodiscard]] std::span<const std::int32_t> nodes(std::int32_t group) const {
        return within(nodes_, first_node_, group);
    }

  private:
    static std::span<const std::int32_t> within(const std::vector<std::int32_t>& all,
                                                const std::vector<std::int32_t>& first, std::int32_t group) {
        const auto g = static_cast<std::size_t>(group);
        return std::span(all).subspan(static_cast<std::size_t>(first[g]),
                                      static_cast<std::size_t>(first[g + 1] - first[g]));
    }
    void split(const Surface& surface, const std::vector<Vec3>& centres, std::span<std::int32_t> facets);

    std::vector<std::int32_t> first_{0}, facets_;
    std::vector<std::int32_t> first_node_{0}, nodes_;
};

}  // namespace weavefront::contact
