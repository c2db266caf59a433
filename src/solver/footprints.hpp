#pragma once
/// @file
/// Which of many footprints come near.

#include <cstdint>
#include <vector>

#include "weavefront/contact/swept_bounds.hpp"

namespace weavefront::solver {

using contact::Footprint;

/// Many footprints, sorted into uniform bins, to be asked for those near another.
class FootprintBins {
  public:
    /// @param reach largest for `near`, m
    FootprintBins(std::vector<Footprint> footprints, double reach);

    /// Whether any comes within `reach` of `other`.
    [[nodiscard]] bool near(const Footprint& other, double reach) const;

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
