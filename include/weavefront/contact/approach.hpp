#pragma once
/// @file
/// How much closer facets have come to what they may meet.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/facet_groups.hpp"

namespace weavefront::contact {

/// Box around the velocities of some nodes, m/s.
class VelocityBox {
  public:
    VelocityBox() = default;
    VelocityBox(std::span<const Vec3> v, std::int32_t first) : low_(load(v, first)), high_(low_) {}

    void add(std::span<const Vec3> v, std::int32_t node) {
        const auto velocity = load(v, node);
        low_ = low_.min(velocity);
        high_ = high_.max(velocity);
    }
    void add(const VelocityBox& other) {
        low_ = low_.min(other.low_);
        high_ = high_.max(other.high_);
    }
    /// Square of the most by which two velocities, one of either box, may differ, m2/s2.
    [[nodiscard]] double squared_difference(const VelocityBox& other) const {
        return (high_ - other.low_).max(other.high_ - low_).head<3>().matrix().squaredNorm();
    }

  private:
    /// With a fourth number, whatever it may be: four are loaded and compared as fast as one.
    [[nodiscard]] static Eigen::Array4d load(std::span<const Vec3> v, std::int32_t node) {
        const auto n = static_cast<std::size_t>(node);
        if (n + 1 == v.size()) return {v[n].x(), v[n].y(), v[n].z(), 0};  // nothing stands after it
        return Eigen::Map<const Eigen::Array4d>(v[n].data());
    }

    Eigen::Array4d low_, high_;
};

/// Bounds from above, step by step, by how much the distance of owned facets to any of their candidates has changed. Between two bilinear
/// facets it changes by no more than two of their nodes move relative to each other, so the bound grows by the diagonal of the box around
/// the motions of all nodes concerned, of a group of neighbouring facets at once. What moves together does not approach.
class Approach {
  public:
    Approach(const Surface& surface, std::span<const Vec3> x);

    /// To be called when candidates or ghosts changed. The bounds so far stay as they are.
    void rebuild(const Surface& surface, const Candidates& candidates, std::span<const Vec3> x);

    /// One step in which every node moved by `dt` times its `v`.
    void advance(std::span<const Vec3> v, double dt);

    /// Groups of owned facets.
    [[nodiscard]] std::int32_t groups() const { return static_cast<std::int32_t>(so_far_.size()); }
    [[nodiscard]] std::span<const std::int32_t> facets(std::int32_t group) const { return groups_.facets(group); }
    /// How many facets are in the groups before.
    [[nodiscard]] std::size_t before(std::int32_t group) const { return groups_.before(group); }
    /// The bound for the facets of a group since the start, m, and its growth in the last step.
    [[nodiscard]] double so_far(std::int32_t group) const { return so_far_[static_cast<std::size_t>(group)].sum; }
    [[nodiscard]] double of_last_step(std::int32_t group) const { return so_far_[static_cast<std::size_t>(group)].last; }

  private:
    FacetGroups groups_;                         ///< of owned facets, then of ghosts
    std::vector<std::int32_t> first_, meeting_;  ///< of each group of owned facets: the groups that hold its candidates
    std::vector<VelocityBox> boxes_;             ///< of each group
    struct Bound {
        double sum = 0, last = 0;  ///< m
    };
    std::vector<Bound> so_far_;
};

}  // namespace weavefront::contact
