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

// Of the touching distance. Candidates farther away are left out of a shortlist, which then holds until they may have come near.
constexpr double near_in_touching = 0.3;

}  // namespace

double room_around(const Outlook& outlook, std::int32_t nearest, Shortlist& shortlist, double so_far, double enough) {
    const auto& [ply, points, candidates, surface, touching, x] = outlook;
    const double beyond = touching.depth() - touching.most();  // facets that are no candidates lie at least this deep
    const double near = near_in_touching * touching.most();
    double room = beyond;
    // By how much something may approach until the facet may touch the box around a candidate.
    const auto look_at = [&](std::int32_t candidate) {
        const auto& other = surface.facets[static_cast<std::size_t>(candidate)];
        const double reach = (1 + rounding) * touching.between(ply, other.ply), apart = points.distance_to(NodeBox(x, other.nodes)) - reach;
        if (apart < room) room = std::min(room, std::max(apart, points.distance_to(corners_of(other.nodes, x)) - reach));
        return apart;
    };
    const auto is_alive = [&](std::int32_t candidate) { return surface.alive[static_cast<std::size_t>(candidate)] != 0; };
    if (so_far < shortlist.until) room = shortlist.until - so_far;
    if (nearest >= 0 && is_alive(nearest)) look_at(nearest);  // mostly it leaves the least room
    if (so_far < shortlist.until) {
        if (room >= enough)
            candidates.visit_some(shortlist.places, [&](std::int32_t candidate) {
                if (candidate != nearest && is_alive(candidate)) look_at(candidate);
                return room >= enough;
            });
        return room < enough ? 0 : room;
    }
    double unlisted = beyond;
    std::uint32_t places = 0;
    auto candidate = candidates.begin();
    for (std::size_t place = 0; candidate != candidates.end() && room >= enough; ++candidate, ++place) {
        if (!is_alive(*candidate)) continue;
        const double apart = *candidate == nearest ? 0 : look_at(*candidate);
        if (apart < near && place < Shortlist::longest)
            places |= std::uint32_t{1} << place;
        else
            unlisted = std::min(unlisted, std::max(apart, 0.0));
    }
    if (room < enough) return 0;
    shortlist = {not_above(so_far + unlisted), places};
    return room;
}

Nearest find_nearest(const Outlook& outlook, const Vec3& centre) {
    const auto& [ply, points, candidates, surface, touching, x] = outlook;
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
