#include "weavefront/contact/near_facets.hpp"

#include <algorithm>

namespace weavefront::contact {

void NearFacets::start(const Facet& facet, const std::array<Vec3, 4>& corners) {
    near_.clear();
    ply_ = facet.ply;
    centre_ = centre_of(corners);
    normal_ = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
    front_ = 0;
    for (const auto& corner : corners) front_ = std::max(front_, (corner - centre_).dot(normal_));
    footprint_ = Footprint::of(Box::around(corners));
}

void NearFacets::add(const FacetRuns& candidates, FacetLines& lines, const Surface& surface, const Touching& touching,
                     std::span<const Vec3> x) {
    const auto known = static_cast<std::ptrdiff_t>(near_.size());
    const auto sooner = [](const Near& l, const Near& r) { return l.ply != r.ply ? l.ply < r.ply : l.apart < r.apart; };
    std::int32_t ply = ply_ + 1;
    bool covered = false, on_rim = false;  // the facet at hand, by this ply; part of that by a rim
    for (const auto candidate : candidates) {
        const auto at = static_cast<std::size_t>(candidate);
        const auto& facet = surface.facets[at];
        if (!surface.alive[at]) continue;
        if (facet.ply != ply) {
            if (covered && !on_rim) break;
            ply = facet.ply;
            covered = on_rim = false;
        }
        const auto box = Box::around(facet, x);
        if (!surface.on_rim.empty() && footprint_.near(Footprint::of(box), touching.depth())) {
            covered = true;
            on_rim = on_rim || surface.on_rim[at] != 0;
        }
        if (!lines.reach(box)) continue;
        if (known > 0 && near_.front().facet == candidate) continue;
        // Seen along the normal of the facet at hand the other must not lie wholly ahead of its foremost corner; a line at a slant only
        // meets it later.
        const auto corners = corners_of(facet.nodes, x);
        double nearest = (corners[0] - centre_).dot(normal_);
        for (std::size_t c = 1; c < 4; ++c) nearest = std::min(nearest, (corners[c] - centre_).dot(normal_));
        if (nearest > front_ + touching.between(ply_, facet.ply)) continue;
        const Near near{candidate, facet.ply, (centre_of(corners) - centre_).squaredNorm()};
        near_.insert(std::upper_bound(near_.begin() + known, near_.end(), near, sooner), near);
    }
}

}  // namespace weavefront::contact
