#include "weavefront/contact/ray_targets.hpp"

#include <algorithm>

namespace weavefront::contact {

void RayTargets::start(const Facet& facet, const std::array<Vec3, 4>& corners) {
    targets_.clear();
    ply_ = facet.ply;
    centre_ = centre_of(corners);
    normal_ = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
    front_ = 0;
    for (const auto& corner : corners) front_ = std::max(front_, (corner - centre_).dot(normal_));
    footprint_ = Footprint::of(Box::around(corners));
}

void RayTargets::add(const FacetRanges& candidates, NormalRays& rays, const Surface& surface,
                     const ContactDistances& distances, std::span<const Vec3> x) {
    const auto known = static_cast<std::ptrdiff_t>(targets_.size());
    const auto sooner = [](const Near& l, const Near& r) {
        return l.ply != r.ply ? l.ply < r.ply : l.apart < r.apart;
    };
    std::int32_t ply = ply_ + 1;
    bool covered = false, on_free_edge = false;  // whether this ply lies over the facet, and with a free edge
    for (const auto candidate : candidates) {
        const auto at = static_cast<std::size_t>(candidate);
        const auto& facet = surface.facets[at];
        if (!surface.alive[at]) continue;
        if (facet.ply != ply) {
            if (covered && !on_free_edge) break;
            ply = facet.ply;
            covered = on_free_edge = false;
        }
        const auto box = Box::around(facet, x);
        if (!surface.on_free_edge.empty() &&
            footprint_.near(Footprint::of(box), distances.max_penetration())) {
            covered = true;
            on_free_edge = on_free_edge || surface.on_free_edge[at] != 0;
        }
        if (!rays.may_reach(box)) continue;
        if (known > 0 && targets_.front().facet == candidate) continue;
        // A candidate wholly ahead of the facet's foremost corner by the contact distance, along the facet's
        // normal, is out of reach. A slanted ray only meets it later.
        const auto corners = corners_of(facet.nodes, x);
        double nearest = (corners[0] - centre_).dot(normal_);
        for (std::size_t c = 1; c < 4; ++c) nearest = std::min(nearest, (corners[c] - centre_).dot(normal_));
        if (nearest > front_ + distances.between(ply_, facet.ply)) continue;
        const Near near{candidate, facet.ply, (centre_of(corners) - centre_).squaredNorm()};
        targets_.insert(std::upper_bound(targets_.begin() + known, targets_.end(), near, sooner), near);
    }
}

}  // namespace weavefront::contact
