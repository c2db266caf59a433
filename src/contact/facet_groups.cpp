#include "weavefront/contact/facet_groups.hpp"

#include <algorithm>
#include <numeric>

namespace weavefront::contact {

namespace {

constexpr std::size_t most_facets = 16;

}  // namespace

void FacetGroups::group(const Surface& surface, std::span<const Vec3> x, std::int32_t first,
                        std::int32_t end) {
    const auto kept = std::ranges::upper_bound(facets_.offsets(), first) - facets_.offsets().begin() - 1;
    facets_.truncate(static_cast<std::size_t>(kept));
    nodes_.truncate(static_cast<std::size_t>(kept));
    std::vector<std::int32_t> facets(static_cast<std::size_t>(end - first));
    std::iota(facets.begin(), facets.end(), first);
    const auto ply_of = [&](std::int32_t f) { return surface.facets[static_cast<std::size_t>(f)].ply; };
    std::ranges::stable_sort(facets, {}, ply_of);
    std::vector<Vec3> centres(static_cast<std::size_t>(end));
    for (const auto f : facets)
        centres[static_cast<std::size_t>(f)] =
            centre_of(corners_of(surface.facets[static_cast<std::size_t>(f)].nodes, x));
    for (auto ply = facets.begin(); ply != facets.end();) {
        const auto next =
            std::find_if(ply, facets.end(), [&](std::int32_t f) { return ply_of(f) != ply_of(*ply); });
        split(surface, centres, {ply, next});
        ply = next;
    }
    nodes_.shrink_to_fit();
}

void FacetGroups::split(const Surface& surface, const std::vector<Vec3>& centres,
                        std::span<std::int32_t> facets) {
    const auto centre = [&](std::int32_t f) -> const Vec3& { return centres[static_cast<std::size_t>(f)]; };
    if (facets.size() > most_facets) {
        Vec3 low = centre(facets[0]), high = low;
        for (const auto f : facets) low = low.cwiseMin(centre(f)), high = high.cwiseMax(centre(f));
        Eigen::Index longest = 0;
        (high - low).maxCoeff(&longest);
        const auto half = facets.size() / 2;
        std::ranges::nth_element(facets, facets.begin() + static_cast<std::ptrdiff_t>(half), {},
                                 [&](std::int32_t f) { return centre(f)[longest]; });
        split(surface, centres, facets.first(half));
        split(surface, centres, facets.subspan(half));
        return;
    }
    std::vector<std::int32_t> nodes;
    for (const auto f : facets) {
        const auto& corners = surface.facets[static_cast<std::size_t>(f)].nodes;
        nodes.insert(nodes.end(), corners.begin(), corners.end());
        facets_.push_back(f);
    }
    facets_.end_row();
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const auto node : nodes) nodes_.push_back(node);
    nodes_.end_row();
}

}  // namespace weavefront::contact
