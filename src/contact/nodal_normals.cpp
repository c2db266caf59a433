#include "weavefront/contact/nodal_normals.hpp"

#include <algorithm>

namespace weavefront::contact {

void NodalNormals::rebuild(const Surface& surface, std::size_t nodes) {
    first_.assign(nodes + 1, 0);
    for (const auto& facet : surface.facets)
        for (const auto node : facet.nodes) ++first_[static_cast<std::size_t>(node) + 1];
    for (std::size_t n = 0; n < nodes; ++n) first_[n + 1] += first_[n];
    around_.resize(static_cast<std::size_t>(first_.back()));
    auto next = first_;
    for (std::size_t f = 0; f < surface.facets.size(); ++f)
        for (const auto node : surface.facets[f].nodes)
            around_[static_cast<std::size_t>(next[static_cast<std::size_t>(node)]++)] = static_cast<std::int32_t>(f);
    const auto by_id = [&](std::int32_t a, std::int32_t b) {
        return surface.facets[static_cast<std::size_t>(a)].id < surface.facets[static_cast<std::size_t>(b)].id;
    };
    for (std::size_t n = 0; n < nodes; ++n) std::sort(around_.begin() + first_[n], around_.begin() + first_[n + 1], by_id);
    places_.resize(nodes);
    computed_.clear();
}

Vec3 NodalNormals::at(std::int32_t node, const Surface& surface, std::span<const Vec3> x) {
    const auto n = static_cast<std::size_t>(node);
    const auto place = static_cast<std::size_t>(places_[n]);
    if (place < computed_.size() && computed_[place].node == node) return computed_[place].normal;
    Vec3 sum = Vec3::Zero();
    for (auto k = first_[n]; k < first_[n + 1]; ++k) {
        const auto f = static_cast<std::size_t>(around_[static_cast<std::size_t>(k)]);
        if (!surface.alive[f]) continue;
        const auto corner = [&](std::size_t a) -> const Vec3& { return x[static_cast<std::size_t>(surface.facets[f].nodes[a])]; };
        sum += (corner(2) - corner(0)).cross(corner(3) - corner(1)) / 2;
    }
    // Add the mirror image of the facets around a node on a plane of symmetry; such a node is held in the plane, at exactly 0.
    for (int d = 0; d < 2; ++d)
        if (surface.symmetry[static_cast<std::size_t>(d)] && x[n][d] == 0) {
            sum *= 2;
            sum[d] = 0;
        }
    places_[n] = static_cast<std::int32_t>(computed_.size());
    computed_.push_back({sum, node});
    return sum;
}

}  // namespace weavefront::contact
