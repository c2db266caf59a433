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
}

void NearFacets::add(const FacetRuns& candidates, FacetLines& lines, const Surface& surface, const Touching& touching,
                     std::span<const Vec3> x) {
    const auto known = static_cast<std::ptrdiff_t>(near_.size());
    const auto sooner = [](const Near& l, const Near& r) { return l.ply != r.ply ? l.ply < r.ply : l.apart < r.apart; };
    for (const auto candidate : candidates) {
        const auto& facet = surface.facets[static_cast<std::size_t>(candidate)];
        if (!surface.alive[static_cast<std::size_t>(candidate)] || !lines.reach(Box::around(facet, x))) continue;
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
