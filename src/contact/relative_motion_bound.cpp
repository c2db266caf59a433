#include "weavefront/contact/relative_motion_bound.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

namespace {

NodeBox box_around(std::span<const std::int32_t> nodes, std::span<const Vec3> v) {
    // Two boxes in turn: their comparisons do not wait for each other.
    NodeBox box(v, nodes.front()), other(v, nodes.back());
    for (std::size_t k = 1; k + 1 < nodes.size(); k += 2) box.add(v, nodes[k]), other.add(v, nodes[k + 1]);
    box.add(other);
    return box;
}

}  // namespace

RelativeMotionBound::RelativeMotionBound(const Surface& surface, std::span<const Vec3> x) {
    groups_.group(surface, x, 0, surface.owned);
    accumulated_.assign(static_cast<std::size_t>(groups_.count()), {});
}

void RelativeMotionBound::rebuild(const Surface& surface, const Candidates& candidates,
                                  std::span<const Vec3> x) {
    groups_.group(surface, x, surface.owned, static_cast<std::int32_t>(surface.facets.size()));
    boxes_.resize(static_cast<std::size_t>(groups_.count()));
    std::vector<std::int32_t> group_of(surface.facets.size());
    for (std::int32_t g = 0; g < groups_.count(); ++g)
        for (const auto f : groups_.facets(g)) group_of[static_cast<std::size_t>(f)] = g;
    first_.assign(1, 0);
    candidate_groups_.clear();
    for (std::int32_t g = 0; g < groups(); ++g) {
        const auto start = first_.back();
        for (const auto f : groups_.facets(g))
            for (const auto other : candidates.of(f)) {
                const auto group = group_of[static_cast<std::size_t>(other)];
                if (std::find(candidate_groups_.begin() + start, candidate_groups_.end(), group) ==
                    candidate_groups_.end())
                    candidate_groups_.push_back(group);
            }
        first_.push_back(static_cast<std::int32_t>(candidate_groups_.size()));
    }
}

void RelativeMotionBound::advance(std::span<const Vec3> v, double dt) {
    for (std::int32_t g = 0; g < groups_.count(); ++g) {
        for (const auto node : groups_.nodes(std::min(g + 2, groups_.count() - 1)))
            __builtin_prefetch(&v[static_cast<std::size_t>(node)]);
        boxes_[static_cast<std::size_t>(g)] = box_around(groups_.nodes(g), v);
    }
    for (std::size_t g = 0; g < accumulated_.size(); ++g) {
        double fastest = 0;
        for (auto k = first_[g]; k < first_[g + 1]; ++k)
            fastest = std::max(
                fastest,
                boxes_[g].squared_difference(
                    boxes_[static_cast<std::size_t>(candidate_groups_[static_cast<std::size_t>(k)])]));
        accumulated_[g].last = dt * std::sqrt(fastest);
        accumulated_[g].sum += accumulated_[g].last;
    }
}

}  // namespace weavefront::contact
