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
    candidate_groups_.truncate(0);
    for (std::int32_t g = 0; g < groups(); ++g) {
        for (const auto f : groups_.facets(g))
            for (const auto other : candidates.of(f)) {
                const auto group = group_of[static_cast<std::size_t>(other)];
                const auto listed = candidate_groups_.open_row();
                if (std::ranges::find(listed, group) == listed.end()) candidate_groups_.push_back(group);
            }
        candidate_groups_.end_row();
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
        for (const auto other : candidate_groups_[g])
            fastest =
                std::max(fastest, boxes_[g].squared_difference(boxes_[static_cast<std::size_t>(other)]));
        accumulated_[g].last = dt * std::sqrt(fastest);
        accumulated_[g].sum += accumulated_[g].last;
    }
}

}  // namespace weavefront::contact
