#pragma once
/// @file
/// Boxes around all facets of a rank.

#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// One array a bound: a search reads mostly `z_low`.
struct FacetBoxes {
    std::vector<double> x_low, x_high, y_low, y_high, z_low, z_high;  ///< m

    /// Boxes at the present positions; those of eroded facets stay as they are.
    void update(const Surface& surface, std::span<const Vec3> x) {
        for (auto* bound : {&x_low, &x_high, &y_low, &y_high, &z_low, &z_high}) bound->resize(surface.facets.size());
        for (std::size_t f = 0; f < surface.facets.size(); ++f) {
            if (!surface.alive[f]) continue;
            const auto box = Box::around(surface.facets[f], x);
            x_low[f] = box.low.x(), y_low[f] = box.low.y(), z_low[f] = box.low.z();
            x_high[f] = box.high.x(), y_high[f] = box.high.y(), z_high[f] = box.high.z();
        }
    }

    /// Whether the box of a facet and another one overlap.
    [[nodiscard]] bool meet(std::size_t f, const Box& box) const {
        return z_low[f] <= box.high.z() && z_high[f] >= box.low.z() && x_low[f] <= box.high.x() && x_high[f] >= box.low.x() &&
               y_low[f] <= box.high.y() && y_high[f] >= box.low.y();
    }
};

}  // namespace weavefront::contact
