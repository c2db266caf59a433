#include "weavefront/contact/nodal_normals.hpp"

#include <algorithm>

#include "weavefront/mesh/adjacency_list.hpp"

namespace weavefront::contact {

void NodalNormals::rebuild(const Surface& surface, std::size_t nodes) {
    mesh::AdjacencyList<std::int32_t> around(nodes, [&](const auto& use) {
        for (std::size_t f = 0; f < surface.facets.size(); ++f)
            for (const auto node : surface.facets[f].nodes) use(node, static_cast<std::int32_t>(f));
    });
    const auto by_id = [&](std::int32_t a, std::int32_t b) {
        return surface.facets[static_cast<std::size_t>(a)].id <
               surface.facets[static_cast<std::size_t>(b)].id;
    };
    around_ = {};
    around_.reserve(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        std::ranges::sort(around[n], by_id);
        for (const auto facet : around[n]) around_.add(facet);
        around_.end_list();
    }
    around_.shrink_to_fit();
    slots_.resize(nodes);
    computed_.clear();
}

Vec3 NodalNormals::at(std::int32_t node, const Surface& surface, std::span<const Vec3> x) {
    const auto n = static_cast<std::size_t>(node);
    const auto slot = static_cast<std::size_t>(slots_[n]);
    if (slot < computed_.size() && computed_[slot].node == node) return computed_[slot].normal;
    Vec3 sum = Vec3::Zero();
    for (const auto facet : around_.of(node)) {
        const auto f = static_cast<std::size_t>(facet);
        if (!surface.alive[f]) continue;
        const auto corner = [&](std::size_t a) -> const Vec3& {
            return x[static_cast<std::size_t>(surface.facets[f].nodes[a])];
        };
        sum += (corner(2) - corner(0)).cross(corner(3) - corner(1)) / 2;
    }
    // A node on a plane of symmetry is held at exactly 0 and has mirrored facets on the other side. They
    // double the sum in the plane and cancel it across the plane.
    for (int d = 0; d < 2; ++d)
        if (surface.symmetry[static_cast<std::size_t>(d)] && x[n][d] == 0) {
            sum *= 2;
            sum[d] = 0;
        }
    slots_[n] = static_cast<std::int32_t>(computed_.size());
    computed_.push_back({sum, node});
    return sum;
}

}  // namespace weavefront::contact
