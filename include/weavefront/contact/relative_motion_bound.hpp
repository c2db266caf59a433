#pragma once
/// @file
/// How much closer facets have come to what they may meet.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/facet_groups.hpp"
#include "weavefront/contact/node_box.hpp"

namespace weavefront::contact {

/// Bounds from above, step by step, by how much the distance of owned facets to any of their candidates has
/// changed. Between two bilinear facets it changes by no more than two of their nodes move relative to each
/// other, so the bound grows by the diagonal of the box around the motions of all nodes concerned, of a group
/// of neighbouring facets at once. What moves together does not approach.
class RelativeMotionBound {
  public:
    RelativeMotionBound(const Surface& surface, std::span<const Vec3> x);

    /// To be called when candidates or ghosts changed. The bounds so far stay as they are.
    void rebuild(const Surface& surface, const Candidates& candidates, std::span<const Vec3> x);

    /// One step in which every node moved by `dt` times its `v`.
    void advance(std::span<const Vec3> v, double dt);

    /// Groups of owned facets.
    [[nodiscard]] std::int32_t groups() const { return static_cast<std::int32_t>(accumulated_.size()); }
    [[nodiscard]] std::span<const std::int32_t> facets(std::int32_t group) const {
        return groups_.facets(group);
    }
    /// How many facets are in the groups before.
    [[nodiscard]] std::size_t before(std::int32_t group) const { return groups_.before(group); }
    /// The bound for the facets of a group since the start, m, and its growth in the last step.
    [[nodiscard]] double accumulated(std::int32_t group) const {
        return accumulated_[static_cast<std::size_t>(group)].sum;
    }
    [[nodiscard]] double of_last_step(std::int32_t group) const {
        return accumulated_[static_cast<std::size_t>(group)].last;
    }

  private:
    FacetGroups groups_;  ///< of owned facets, then of ghosts
    std::vector<std::int32_t> first_,
        candidate_groups_;        ///< of each group of owned facets: the groups that hold its candidates
    std::vector<NodeBox> boxes_;  ///< of each group
    struct Bound {
        double sum = 0, last = 0;  ///< m
    };
    std::vector<Bound> accumulated_;
};

}  // namespace weavefront::contact
