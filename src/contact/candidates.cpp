#include "weavefront/contact/candidates.hpp"

#include <algorithm>
#include <vector>

#include "weavefront/contact/footprint_bins.hpp"

namespace weavefront::contact {

Candidates find_candidates(const Surface& surface, const SweptBounds& swept, double reach) {
    std::vector<Footprint> footprints(surface.facets.size());
    std::vector<std::vector<std::int32_t>> by_ply(surface.plies.size());
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
        if (!surface.alive[f]) continue;
        footprints[f] = swept.of(surface.facets[f]);
        by_ply[static_cast<std::size_t>(surface.facets[f].ply)].push_back(static_cast<std::int32_t>(f));
    }
    std::vector<FootprintBins> bins;
    for (const auto& facets : by_ply) bins.emplace_back(footprints, facets, reach);

    Candidates candidates;
    candidates.reserve(static_cast<std::size_t>(surface.owned));
    std::vector<std::int32_t> found;
    const auto id = [&](std::int32_t f) { return surface.facets[static_cast<std::size_t>(f)].id; };
    const auto by_id = [&](std::int32_t a, std::int32_t b) {
        const bool same_side =
            (a < surface.owned) == (b < surface.owned);  // where local order is that of the ids
        return same_side ? a < b : id(a) < id(b);
    };
    const auto on_free_edge = [&](std::int32_t f) {
        return surface.on_free_edge[static_cast<std::size_t>(f)] != 0;
    };
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        const auto& footprint = footprints[static_cast<std::size_t>(f)];
        bool look_behind = surface.alive[static_cast<std::size_t>(f)] != 0;
        for (auto ply = static_cast<std::size_t>(facet.ply) + 1; ply < surface.plies.size() && look_behind;
             ++ply) {
            found.clear();
            bins[ply].visit_near(footprint, reach, [&](std::int32_t other) {
                found.push_back(other);
                return true;
            });
            std::ranges::sort(found, by_id);
            for (const auto other : found) candidates.add(other);
            look_behind =
                !surface.on_free_edge.empty() && (found.empty() || std::ranges::any_of(found, on_free_edge));
        }
        candidates.end_list();
    }
    candidates.shrink_to_fit();
    return candidates;
}

}  // namespace weavefront::contact
