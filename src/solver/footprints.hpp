#pragma once
/// @file
/// Footprints of facets, and which of them come near.

#include <cstdint>
#include <limits>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::solver {

/// A rectangle in x and y, m; empty until it includes something.
struct Footprint {
    double x_low = std::numeric_limits<double>::max(), x_high = -x_low, y_low = x_low, y_high = -x_low;

    static Footprint of(const contact::Facet& facet, std::span<const Vec3> x);
    void include(const Footprint& other);
    /// Whether `other` comes within `reach` of this one; never when this one is empty.
    [[nodiscard]] bool near(const Footprint& other, double reach) const {
        return other.x_low <= x_high + reach && other.x_high >= x_low - reach && other.y_low <= y_high + reach &&
               other.y_high >= y_low - reach;
    }
};

/// Many footprints, sorted into uniform bins, to be asked for those near another.
class FootprintBins {
  public:
    /// @param reach as for `near`, m
    FootprintBins(std::vector<Footprint> footprints, double reach);

    /// Whether any comes within the reach of `other`.
    [[nodiscard]] bool near(const Footprint& other) const;

  private:
    struct Bins {
        std::int64_t i0, i1, j0, j1;
    };
    [[nodiscard]] Bins touched(const Footprint& footprint) const;

    std::vector<Footprint> footprints_;
    double reach_, size_ = 0;
    Footprint all_;
    std::int64_t nx_ = 1, ny_ = 1;
    std::vector<std::size_t> first_;    // of each bin
    std::vector<std::int32_t> listed_;  // footprints that come within the reach of the bin
};

}  // namespace weavefront::solver
