#pragma once
/// @file
/// Bounds on the relative motion of facets and their candidates.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/facet_groups.hpp"
#include "weavefront/contact/node_box.hpp"
#include "weavefront/mesh/adjacency_list.hpp"

namespace weavefront::contact {

/// Accumulates, by group of neighbouring owned facets, an upper bound on the change of their distances to all
/// candidates. The distance of two bilinear facets changes by at most the largest relative motion of two of
/// their nodes. So the bound grows by the diagonal of the box of all relative velocities, times the step.
/// Common motion of facets and candidates does not count.
class RelativeMotionBound {
  public:
    /// Groups the owned facets. @param x initial positions, m
    RelativeMotionBound(const Surface& surface, std::span<const Vec3> x);

    /// Adopts new candidates and ghosts. Accumulated bounds are kept. @param x present positions, m
    void rebuild(const Surface& surface, const Candidates& candidates, std::span<const Vec3> x);

    /// Advances by a step in which every node moved by `dt` times its velocity. @param v m/s @param dt s
    void advance(std::span<const Vec3> v, double dt);

    /// Number of groups of owned facets.
    [[nodiscard]] std::int32_t groups() const { return static_cast<std::int32_t>(accumulated_.size()); }
    /// Local indices of the facets of a group.
    [[nodiscard]] std::span<const std::int32_t> facets(std::int32_t group) const {
        return groups_.facets(group);
    }
    /// Number of facets in all groups before this one.
    [[nodiscard]] std::size_t before(std::int32_t group) const { return groups_.before(group); }
    /// Bound for the facets of a group since the start, m.
    [[nodiscard]] double accumulated(std::int32_t group) const {
        return accumulated_[static_cast<std::size_t>(group)].sum;
    }
    /// Growth of the bound in the last step, m.
    [[nodiscard]] double of_last_step(std::int32_t group) const {
        return accumulated_[static_cast<std::size_t>(group)].last;
    }

  private:
    FacetGroups groups_;  ///< of owned facets, then of ghosts
    mesh::AdjacencyList<std::int32_t>
        candidate_groups_;        ///< by group of owned facets: groups of its candidates
    std::vector<NodeBox> boxes_;  ///< by group, around the velocities of its nodes
    struct Bound {
        double sum = 0, last = 0;  ///< m
    };
    std::vector<Bound> accumulated_;
};

}  // namespace weavefront::contact
