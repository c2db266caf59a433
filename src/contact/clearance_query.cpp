#include "weavefront/contact/clearance_query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::contact {

namespace {

// Relative margin of the contact distance for rounding. A hit that rounding puts off its ray by e seems
// nearer by e^2/2 over its distance. This margin covers every e up to a hundredth of the contact distance,
// far more than rounding makes.
constexpr double rounding = 1e-4;

// Over the contact distance. A shortlist leaves out candidates with more clearance than this, and holds until
// one of them may have used it up.
constexpr double near_in_distance = 0.3;

}  // namespace

double clearance(const ClearanceQuery& query, std::int32_t nearest, Shortlist& shortlist, double accumulated,
                 double worthwhile) {
    const ContactPoints& points = query.points;
    const FacetRanges& candidates = query.candidates;
    const Surface& surface = query.surface;
    const ContactDistances& distances = query.distances;
    const double beyond =
        distances.max_penetration() - distances.most();  // clearance of facets that are no candidates
    const double near = near_in_distance * distances.most();
    double clear = beyond;
    // Clearance towards the box around a candidate. Where it is the least so far, the candidate itself is
    // measured.
    const auto measure = [&](std::int32_t candidate) {
        const auto& other = surface.facets[static_cast<std::size_t>(candidate)];
        const double reach = (1 + rounding) * distances.between(query.ply, other.ply),
                     apart = points.min_distance(NodeBox(query.x, other.nodes)) - reach;
        if (apart < clear)
            clear = std::min(clear,
                             std::max(apart, points.min_distance(corners_of(other.nodes, query.x)) - reach));
        return apart;
    };
    const auto is_alive = [&](std::int32_t candidate) {
        return surface.alive[static_cast<std::size_t>(candidate)] != 0;
    };
    if (accumulated < shortlist.until) clear = shortlist.until - accumulated;
    if (nearest >= 0 && is_alive(nearest)) measure(nearest);  // it mostly has the least clearance
    if (accumulated < shortlist.until) {
        if (clear >= worthwhile)
            candidates.visit_some(shortlist.slots, [&](std::int32_t candidate) {
                if (candidate != nearest && is_alive(candidate)) measure(candidate);
                return clear >= worthwhile;
            });
        return clear < worthwhile ? 0 : clear;
    }
    double unlisted = beyond;
    std::uint32_t slots = 0;
    auto candidate = candidates.begin();
    for (std::size_t slot = 0; candidate != candidates.end() && clear >= worthwhile; ++candidate, ++slot) {
        if (!is_alive(*candidate)) continue;
        const double apart = *candidate == nearest ? 0 : measure(*candidate);
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
    const FacetRanges& candidates = query.candidates;
    const Surface& surface = query.surface;
    if (candidates.empty() || surface.facets[static_cast<std::size_t>(candidates.back())].ply > query.ply + 1)
        return {};
    Nearest found;
    double nearest = std::numeric_limits<double>::max(), second = nearest;
    for (const auto candidate : candidates) {
        if (!surface.alive[static_cast<std::size_t>(candidate)]) continue;
        const double apart =
            (centre_of(corners_of(surface.facets[static_cast<std::size_t>(candidate)].nodes, query.x)) -
             centre)
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
