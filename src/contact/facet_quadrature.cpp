#include "weavefront/contact/facet_quadrature.hpp"

namespace weavefront::contact {

FacetQuadrature::FacetQuadrature(std::optional<double> spacing, const Surface& surface,
                                 std::span<const Vec3> x, int most)
    : quadrature_(spacing, most) {
    const auto shapes = surface.areas.one_ply.size();
    rules_.one_ply.reserve(shapes);
    for (std::size_t f = 0; f < shapes; ++f)
        rules_.one_ply.push_back(quadrature_.rule_for(corners_of(surface.facets[f].nodes, x)));
}

}  // namespace weavefront::contact
