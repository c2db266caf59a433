#include "weavefront/contact/facets_behind.hpp"

#include "weavefront/contact/ray.hpp"

namespace weavefront::contact {

std::vector<std::int32_t> facets_behind_next_ply(const Surface& surface, const Candidates& candidates,
                                                 const ContactDistances& distances, std::span<const Vec3> x) {
    const auto counts = [&](std::int32_t f) {
        const auto i = static_cast<std::size_t>(f);
        return surface.alive[i] && (surface.on_free_edge.empty() || !surface.on_free_edge[i]);
    };
    std::vector<std::int32_t> behind;
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        if (!counts(f)) continue;
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        const auto corners = corners_of(facet.nodes, x);
        const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
        const auto ray = one_ray(centre_of(corners), normal);
        for (const auto candidate : candidates.of(f)) {
            const auto& next = surface.facets[static_cast<std::size_t>(candidate)];
            if (next.ply != facet.ply + 1 || !counts(candidate)) continue;
            const auto hits = intersect(ray, corners_of(next.nodes, x));
            if (!hits.hit[0] || hits.distance[0] > -distances.between(facet.ply, next.ply)) continue;
            behind.push_back(f);
            break;
        }
    }
    return behind;
}

}  // namespace weavefront::contact
