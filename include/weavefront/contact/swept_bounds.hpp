#pragma once
/// @file
/// Rectangles in x and y that nodes and facets sweep until the next search for candidates.

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// A rectangle in x and y, m. It is empty at first.
struct Footprint {
    double x_low = std::numeric_limits<double>::max(), x_high = -x_low, y_low = x_low, y_high = -x_low;

    static Footprint of(const Box& box) { return {box.low.x(), box.high.x(), box.low.y(), box.high.y()}; }

    void include(const Footprint& other) {
        x_low = std::min(x_low, other.x_low), x_high = std::max(x_high, other.x_high);
        y_low = std::min(y_low, other.y_low), y_high = std::max(y_high, other.y_high);
    }
    /// Whether `other` lies within `reach` (m) of this footprint along x and y. False if this footprint is
    /// empty.
    [[nodiscard]] bool near(const Footprint& other, double reach) const {
        return other.x_low <= x_high + reach && other.x_high >= x_low - reach &&
               other.y_low <= y_high + reach && other.y_high >= y_low - reach;
    }
};

/// Footprints that nodes sweep at constant velocity. Fragments that fly fast and straight stay in their
/// footprints and cause no search. Single precision suffices: its error of some nanometres is far below the
/// skin of a search.
class SweptBounds {
  public:
    SweptBounds() = default;
    /// @param v     velocities, m/s
    /// @param ahead time until the next search, s
    SweptBounds(std::span<const Vec3> x, std::span<const Vec3> v, double ahead);
    /// Footprints of nodes at rest. @param x m
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

    /// Lets a node be anywhere: `any_outside` does not count it any more.
    void ignore(std::size_t node) { halves_[node].fill(std::numeric_limits<float>::max()); }

    /// Whether one of the first nodes is farther than `margin` (m) outside of its footprint along x or y.
    /// @param x positions of the first nodes, m
    [[nodiscard]] bool any_outside(std::span<const Vec3> x, double margin) const;

  private:
    std::vector<std::array<float, 2>> middles_,
        halves_;  ///< by node: centre and half size of its footprint, m
};

}  // namespace weavefront::contact
