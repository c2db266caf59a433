#pragma once
/// @file
/// Where nodes and facets are expected, as seen along z, until the next search for what may meet.

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// A rectangle in x and y, m; empty until it includes something.
struct Footprint {
    double x_low = std::numeric_limits<double>::max(), x_high = -x_low, y_low = x_low, y_high = -x_low;

    static Footprint of(const Box& box) { return {box.low.x(), box.high.x(), box.low.y(), box.high.y()}; }

    void include(const Footprint& other) {
        x_low = std::min(x_low, other.x_low), x_high = std::max(x_high, other.x_high);
        y_low = std::min(y_low, other.y_low), y_high = std::max(y_high, other.y_high);
    }
    /// Whether `other` comes within `reach` of this one; never when this one is empty.
    [[nodiscard]] bool near(const Footprint& other, double reach) const {
        return other.x_low <= x_high + reach && other.x_high >= x_low - reach &&
               other.y_low <= y_high + reach && other.y_high >= y_low - reach;
    }
};

/// Footprints of nodes on their way ahead. Fragments that fly fast but straight stay in theirs, and ask for
/// no search on the way. Single precision: some nanometres are nothing to the skin of a search.
class SweptBounds {
  public:
    SweptBounds() = default;
    /// @param v     velocities, m/s, that the nodes may keep
    /// @param ahead for so long, s
    SweptBounds(std::span<const Vec3> x, std::span<const Vec3> v, double ahead);
    /// Nodes that stay where they are.
    explicit SweptBounds(std::span<const Vec3> x) : SweptBounds(x, x, 0) {}

    [[nodiscard]] bool empty() const { return middles_.empty(); }
    [[nodiscard]] Footprint of_node(std::size_t node) const {
        const double x = middles_[node][0], y = middles_[node][1], half_x = halves_[node][0],
                     half_y = halves_[node][1];
        return {x - half_x, x + half_x, y - half_y, y + half_y};
    }
    [[nodiscard]] Footprint of(const Facet& facet) const {
        Footprint footprint;
        for (const auto node : facet.nodes) footprint.include(of_node(static_cast<std::size_t>(node)));
        return footprint;
    }

    /// From now on a node is expected everywhere.
    void ignore(std::size_t node) { halves_[node].fill(std::numeric_limits<float>::max()); }

    /// Whether one of the first nodes is farther than `margin` from its footprint along x or y. @param x of
    /// these nodes, m
    [[nodiscard]] bool any_outside(std::span<const Vec3> x, double margin) const;

  private:
    std::vector<std::array<float, 2>> middles_, halves_;  ///< of the nodes' footprints, m
};

}  // namespace weavefront::contact
