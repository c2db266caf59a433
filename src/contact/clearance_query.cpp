#include "weavefront/contact/clearance_query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::contact {

namespace {

// What a line is found to meet lies on the facet; where rounding puts it off the line by e it seems nearer by
// e^2/2 over its distance. Facets this much farther apart than their touching distance are clear of each
// other for all e up to a hundredth of that distance, far above what rounding makes of a line.
constexpr double rounding = 1e-4;

// Of the touching distance. Candidates farther away are left out of a shortlist, which then holds until they
// may have come near.
constexpr double near_in_distance = 0.3;

}  // namespace

double clearance(const ClearanceQuery& query, std::int32_t nearest, Shortlist& shortlist, double accumulated,
                 double worthwhile) {
    const auto& [ply, points, candidates, surface, distances, x] = query;
    const double beyond = distances.max_penetration() -
                          distances.most();  // facets that are no candidates lie at least this deep
    const double near = near_in_distance * distances.most();
    double clear = beyond;
    // By how much something may approach until the facet may touch the box around a candidate.
    const auto look_at = [&](std::int32_t candidate) {
        const auto& other = surface.facets[static_cast<std::size_t>(candidate)];
        const double reach = (1 + rounding) * distances.between(ply, other.ply),
                     apart = points.min_distance(NodeBox(x, other.nodes)) - reach;
        if (apart < clear)
            clear = std::min(clear, std::max(apart, points.min_distance(corners_of(other.nodes, x)) - reach));
        return apart;
    };
    const auto is_alive = [&](std::int32_t candidate) {
        return surface.alive[static_cast<std::size_t>(candidate)] != 0;
    };
    if (accumulated < shortlist.until) clear = shortlist.until - accumulated;
    if (nearest >= 0 && is_alive(nearest)) look_at(nearest);  // mostly it leaves the least clear
    if (accumulated < shortlist.until) {
        if (clear >= worthwhile)
            candidates.visit_some(shortlist.slots, [&](std::int32_t candidate) {
                if (candidate != nearest && is_alive(candidate)) look_at(candidate);
                return clear >= worthwhile;
            });
        return clear < worthwhile ? 0 : clear;
    }
    double unlisted = beyond;
    std::uint32_t slots = 0;
    auto candidate = candidates.begin();
    for (std::size_t slot = 0; candidate != candidates.end() && clear >= worthwhile; ++candidate, ++slot) {
        if (!is_alive(*candidate)) continue;
        const double apart = *candidate == nearest ? 0 : look_at(*candidate);
        if (apart < near && slot < Shortlist::longest)
            slots |= std::uint32_t{1} << slot;
        else
            unlisted = std::min(unlisted, std::max(apart, 0.0));
    }
    if (clear < worthwhile) return 0;
    shortlist = {not_above(accumulated + unlisted), slots};
    return clear;
}

Nearest find_nearest(const ClearanceQuery& query, const Vec3& centre) {
    const auto& [ply, points, candidates, surface, distances, x] = query;
    if (candidates.empty() || surface.facets[static_cast<std::size_t>(candidates.back())].ply > ply + 1)
        return {};
    Nearest found;
    double nearest = std::numeric_limits<double>::max(), second = nearest;
    for (const auto candidate : candidates) {
        if (!surface.alive[static_cast<std::size_t>(candidate)]) continue;
        const double apart =
            (centre_of(corners_of(surface.facets[static_cast<std::size_t>(candidate)].nodes, x)) - centre)
                .squaredNorm();
        second = std::min(second, std::max(apart, nearest));
        if (apart >= nearest) continue;
        nearest = apart;
        found.facet = candidate;
    }
    found.lead = (1 - rounding) * (std::sqrt(second) - std::sqrt(nearest)) / 2;
    return found;
}

}  // namespace weavefront::contact
