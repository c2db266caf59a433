#include "weavefront/contact/outlook.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::contact {

namespace {

// What a line is found to meet lies on the facet; where rounding puts it off the line by e it seems nearer by e^2/2 over its distance.
// Facets this much farther apart than their touching distance are clear of each other for all e up to a hundredth of that distance, far
// above what rounding makes of a line.
constexpr double rounding = 1e-4;

}  // namespace

double room_around(std::int32_t ply, const Viewpoints& points, std::int32_t nearest, const FacetRuns& candidates, const Surface& surface,
                   const Touching& touching, std::span<const Vec3> x, double enough) {
    double room = touching.depth() - touching.most();  // facets that are no candidates lie at least this deep
    const auto make_room = [&](std::int32_t candidate) {
        const auto& other = surface.facets[static_cast<std::size_t>(candidate)];
        if (!surface.alive[static_cast<std::size_t>(candidate)]) return;
        const double reach = (1 + rounding) * touching.between(ply, other.ply);
        room = std::min(room, points.distance_to(corners_of(other.nodes, x), room + reach) - reach);
        if (room < enough) room = 0;
    };
    if (nearest >= 0) make_room(nearest);  // the others most often lie beyond the room that this one leaves
    for (const auto candidate : candidates)
        if (room > 0 && candidate != nearest) make_room(candidate);
    return room;
}

Nearest find_nearest(std::int32_t ply, const Vec3& centre, const FacetRuns& candidates, const Surface& surface, std::span<const Vec3> x) {
    if (candidates.empty() || surface.facets[static_cast<std::size_t>(candidates.back())].ply > ply + 1) return {};
    Nearest found;
    double nearest = std::numeric_limits<double>::max(), second = nearest;
    for (const auto candidate : candidates) {
        if (!surface.alive[static_cast<std::size_t>(candidate)]) continue;
        const double apart = (centre_of(corners_of(surface.facets[static_cast<std::size_t>(candidate)].nodes, x)) - centre).squaredNorm();
        second = std::min(second, std::max(apart, nearest));
        if (apart >= nearest) continue;
        nearest = apart;
        found.facet = candidate;
    }
    found.lead = (1 - rounding) * (std::sqrt(second) - std::sqrt(nearest)) / 2;
    return found;
}

}  // namespace weavefront::contact
