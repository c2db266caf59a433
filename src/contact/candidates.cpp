#include "weavefront/contact/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>

namespace weavefront::contact {

namespace {

/// Uniform bins over x and y; a facet is listed in every bin that its footprint touches.
class Bins {
  public:
    Bins(const std::vector<Footprint>& footprints, const std::vector<std::int32_t>& facets, double size)
        : footprints_(footprints), size_(size) {
        for (const auto f : facets) all_.include(footprints[static_cast<std::size_t>(f)]);
        nx_ = count(all_.x_high - all_.x_low);
        ny_ = count(all_.y_high - all_.y_low);
        first_.assign(static_cast<std::size_t>(nx_ * ny_) + 1, 0);
        for (const auto f : facets)
            visit(range(footprints[static_cast<std::size_t>(f)], 0),
                  [&](auto i, auto j) { ++first_[index(i, j)]; });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        listed_.resize(static_cast<std::size_t>(first_.back()));
        for (const auto f : facets | std::views::reverse) {
            const auto own = range(footprints[static_cast<std::size_t>(f)], 0);
            visit(own, [&](auto i, auto j) {
                listed_[static_cast<std::size_t>(--first_[index(i, j)])] = {f, i == own.i0, j == own.j0};
            });
        }
    }

    /// Calls `use` once with each facet whose footprint comes within `reach` of the one given.
    template <class Use>
    void find(const Footprint& footprint, double reach, Use use) const {
        const auto around = range(footprint, reach);
        visit(around, [&](std::int64_t i, std::int64_t j) {
            const auto bin = index(i, j);
            for (auto k = first_[bin]; k < first_[bin + 1]; ++k) {
                const auto& [facet, first_column, first_row] = listed_[static_cast<std::size_t>(k)];
                // A facet is used in the first of the bins that it shares with the footprint.
                if ((first_column || i == around.i0) && (first_row || j == around.j0) &&
                    footprint.near(footprints_[static_cast<std::size_t>(facet)], reach))
                    use(facet);
            }
        });
    }

  private:
    /// Bins from (i0, j0) to (i1, j1).
    struct Range {
        std::int64_t i0, i1, j0, j1;
    };
    [[nodiscard]] Range range(const Footprint& of, double reach) const {
        return {along(of.x_low - reach - all_.x_low, nx_), along(of.x_high + reach - all_.x_low, nx_),
                along(of.y_low - reach - all_.y_low, ny_), along(of.y_high + reach - all_.y_low, ny_)};
    }
    template <class Use>
    void visit(const Range& range, Use use) const {
        for (auto j = range.j0; j <= range.j1; ++j)
            for (auto i = range.i0; i <= range.i1; ++i) use(i, j);
    }
    [[nodiscard]] std::size_t index(std::int64_t i, std::int64_t j) const {
        return static_cast<std::size_t>(j * nx_ + i);
    }
    // Fragments can fly far. Past 4096 bins a side the last bin takes all others.
    [[nodiscard]] std::int64_t count(double extent) const {
        return static_cast<std::int64_t>(std::clamp(extent / size_, 0.0, 4095.0)) + 1;
    }
    [[nodiscard]] std::int64_t along(double offset, std::int64_t n) const {
        return static_cast<std::int64_t>(std::clamp(offset / size_, 0.0, static_cast<double>(n - 1)));
    }

    const std::vector<Footprint>& footprints_;
    double size_;
    Footprint all_;
    std::int64_t nx_ = 1, ny_ = 1;
    struct Listing {
        std::int32_t facet;
        bool first_column, first_row;  ///< of the bins that the facet touches
    };
    std::vector<std::int32_t> first_;  ///< of each bin
    std::vector<Listing> listed_;
};

}  // namespace

Candidates find_candidates(const Surface& surface, const SweptBounds& swept, double reach) {
    std::vector<Footprint> footprints(surface.facets.size());
    std::vector<std::vector<std::int32_t>> by_ply(surface.plies.size());
    double sum = 0, alive = 0;
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
        if (!surface.alive[f]) continue;
        auto& one = footprints[f] = swept.of(surface.facets[f]);
        by_ply[static_cast<std::size_t>(surface.facets[f].ply)].push_back(static_cast<std::int32_t>(f));
        sum += std::max(one.x_high - one.x_low, one.y_high - one.y_low);
        ++alive;
    }
    // Bins of about the mean facet size keep the lists short on graded meshes.
    const double size = std::max(reach, sum / std::max(alive, 1.0));
    std::vector<Bins> bins;
    for (const auto& facets : by_ply) bins.emplace_back(footprints, facets, size);

    Candidates candidates;
    candidates.reserve(static_cast<std::size_t>(surface.owned));
    std::vector<std::int32_t> found;
    const auto id = [&](std::int32_t f) { return surface.facets[static_cast<std::size_t>(f)].id; };
    const auto by_id = [&](std::int32_t a, std::int32_t b) {
        const bool same_side =
            (a < surface.owned) == (b < surface.owned);  // where local order is that of the ids
        return same_side ? a < b : id(a) < id(b);
    };
    const auto on_free_edge = [&](std::int32_t f) {
        return surface.on_free_edge[static_cast<std::size_t>(f)] != 0;
    };
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        const auto& footprint = footprints[static_cast<std::size_t>(f)];
        bool look_behind = surface.alive[static_cast<std::size_t>(f)] != 0;
        for (auto ply = static_cast<std::size_t>(facet.ply) + 1; ply < surface.plies.size() && look_behind;
             ++ply) {
            found.clear();
            bins[ply].find(footprint, reach, [&](std::int32_t other) { found.push_back(other); });
            std::ranges::sort(found, by_id);
            for (const auto other : found) candidates.add(other);
            look_behind =
                !surface.on_free_edge.empty() && (found.empty() || std::ranges::any_of(found, on_free_edge));
        }
        candidates.end_list();
    }
    candidates.shrink_to_fit();
    return candidates;
}

}  // namespace weavefront::contact
