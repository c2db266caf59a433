#pragma once
/// @file
/// Bins over x and y for the search of footprints.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/swept_bounds.hpp"
#include "weavefront/mesh/adjacency_list.hpp"

namespace weavefront::contact {

/// Uniform bins over x and y, each with the footprints that overlap it. The bins only speed the search up:
/// what it finds does not depend on them.
class FootprintBins {
  public:
    /// Bins of the mean footprint size keep the lists short on graded meshes, but none is smaller than
    /// `reach`.
    /// @param footprints seen, not copied: they must outlive the bins
    /// @param chosen     indices of the footprints to put in
    /// @param reach      typical reach of the searches, m
    FootprintBins(std::span<const Footprint> footprints, std::span<const std::int32_t> chosen, double reach);
    /// Puts all footprints in.
    FootprintBins(std::span<const Footprint> footprints, double reach);

    /// Visits each footprint within `reach` of another one once, until `visit` returns false.
    /// @param reach m
    /// @param visit function of the footprint's index; returns whether to go on
    template <class Visit>
    void visit_near(const Footprint& other, double reach, const Visit& visit) const {
        if (!all_.near(other, reach)) return;
        const auto range = bins_touched(other, reach);
        for (auto j = range.j0; j <= range.j1; ++j)
            for (auto i = range.i0; i <= range.i1; ++i)
                for (const auto& [footprint, in_first_column, in_first_row] : bins_[j * nx_ + i]) {
                    // A footprint is visited in the first of the bins that it shares with the range.
                    const bool is_first =
                        (in_first_column || i == range.i0) && (in_first_row || j == range.j0);
                    if (is_first && other.near(footprints_[static_cast<std::size_t>(footprint)], reach) &&
                        !visit(footprint))
                        return;
                }
    }

    /// Whether any footprint lies within `reach` (m) of another one.
    [[nodiscard]] bool any_near(const Footprint& other, double reach) const {
        bool found = false;
        visit_near(other, reach, [&](std::int32_t) {
            found = true;
            return false;
        });
        return found;
    }

  private:
    /// Bins from (i0, j0) to (i1, j1).
    struct Range {
        std::int64_t i0, i1, j0, j1;
    };
    struct Entry {
        std::int32_t footprint;
        bool in_first_column,
            in_first_row;  ///< whether the bin is in the first ones that the footprint overlaps
    };
    [[nodiscard]] Range bins_touched(const Footprint& footprint, double reach) const;

    std::span<const Footprint> footprints_;
    Footprint all_;  ///< around all that were put in
    double size_ = 1;
    std::int64_t nx_ = 1, ny_ = 1;
    mesh::AdjacencyList<Entry> bins_;  ///< by bin, column by column within a row of bins
};

}  // namespace weavefront::contact
