#include "weavefront/contact/outlook.hpp"

#include <algorithm>
#include <limits>

#include "weavefront/contact/outline.hpp"

namespace weavefront::contact {

namespace {

// A line that meets a facet at a very small angle is not known to the last bits: facets this much farther apart than their touching
// distance are safely clear of each other.
constexpr double rounding = 0.01;

/// Finds the candidate whose centre is nearest to that of the facet; it must lie in the next ply.
void find_first(Outlook& outlook, std::int32_t ply, const Vec3& centre, const FacetRuns& candidates, const Surface& surface,
                std::span<const Vec3> x) {
    if (candidates.empty() || surface.facets[static_cast<std::size_t>(candidates.back())].ply > ply + 1) return;
    double nearest = std::numeric_limits<double>::max(), second = nearest;
    for (const auto candidate : candidates) {
        const auto other = static_cast<std::size_t>(candidate);
        if (!surface.alive[other]) continue;
        const double apart = (centre_of(corners_of(surface.facets[other].nodes, x)) - centre).squaredNorm();
        second = std::min(second, std::max(apart, nearest));
        if (apart >= nearest) continue;
        nearest = apart;
        outlook.first = candidate;
    }
    outlook.lead = (1 - rounding) * (std::sqrt(second) - std::sqrt(nearest)) / 2;
}

}  // namespace

Outlook look_around(std::int32_t f, const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& spanned, const FacetRuns& candidates,
                    const Surface& surface, const Touching& touching, std::span<const Vec3> x, double enough) {
    const auto ply = surface.facets[static_cast<std::size_t>(f)].ply;
    const Outline outline(spanned);
    Outlook outlook{.room = touching.depth() - touching.most()};  // facets that are no candidates lie at least this deep
    find_first(outlook, ply, centre_of(corners), candidates, surface, x);
    const auto make_room = [&](std::int32_t candidate) {
        const auto& other = surface.facets[static_cast<std::size_t>(candidate)];
        if (!surface.alive[static_cast<std::size_t>(candidate)]) return;
        const double reach = (1 + rounding) * touching.between(ply, other.ply);
        outlook.room = std::min(outlook.room, outline.distance_to(Outline(corners_of(other.nodes, x)), outlook.room + reach) - reach);
        if (outlook.room < enough) outlook.room = 0;
    };
    if (outlook.first >= 0) make_room(outlook.first);  // most often this settles it
    for (const auto candidate : candidates)
        if (outlook.room > 0) make_room(candidate);
    return outlook;
}

}  // namespace weavefront::contact
