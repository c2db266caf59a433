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

    [[nodiscard]] Box of(std::int32_t facet) const {
        const auto f = static_cast<std::size_t>(facet);
        return {{x_low[f], y_low[f], z_low[f]}, {x_high[f], y_high[f], z_high[f]}};
    }

    /// Whether a facet lies within `reach` of a box in x and y, and not more than that behind it in z.
    [[nodiscard]] bool meet(std::size_t f, const Box& box, double reach) const {
        return z_high[f] >= box.low.z() - reach && x_low[f] <= box.high.x() + reach && x_high[f] >= box.low.x() - reach &&
               y_low[f] <= box.high.y() + reach && y_high[f] >= box.low.y() - reach;
    }
};

}  // namespace weavefront::contact
