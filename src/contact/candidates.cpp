#include "weavefront/contact/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>

namespace weavefront::contact {

namespace {

bool footprints_meet(const Box& a, const Box& b, double reach) {
    return a.low.x() <= b.high.x() + reach && a.high.x() >= b.low.x() - reach && a.low.y() <= b.high.y() + reach &&
           a.high.y() >= b.low.y() - reach;
}

/// Uniform bins over x and y; a facet is listed in every bin that its footprint touches.
class Bins {
  public:
    Bins(const std::vector<Box>& boxes, const std::vector<std::int32_t>& facets, double size) : boxes_(boxes), size_(size) {
        Vec3 high = Vec3::Constant(-1e300);
        for (const auto f : facets) {
            low_ = low_.cwiseMin(boxes[static_cast<std::size_t>(f)].low);
            high = high.cwiseMax(boxes[static_cast<std::size_t>(f)].high);
        }
        nx_ = count(high.x() - low_.x());
        ny_ = count(high.y() - low_.y());
        first_.assign(static_cast<std::size_t>(nx_ * ny_) + 1, 0);
        for (const auto f : facets) visit(range(boxes[static_cast<std::size_t>(f)], 0), [&](auto bin) { ++first_[bin]; });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        listed_.resize(static_cast<std::size_t>(first_.back()));
        for (const auto f : facets | std::views::reverse)
            visit(range(boxes[static_cast<std::size_t>(f)], 0), [&](auto bin) { listed_[static_cast<std::size_t>(--first_[bin])] = f; });
    }

    /// Calls `use` once with each facet whose footprint comes within `reach` of that of a box.
    template <class Use>
    void find(const Box& box, double reach, Use use) const {
        const auto around = range(box, reach);
        visit(around, [&](std::size_t bin) {
            for (auto k = first_[bin]; k < first_[bin + 1]; ++k) {
                const auto facet = listed_[static_cast<std::size_t>(k)];
                const auto& other = boxes_[static_cast<std::size_t>(facet)];
                if (!footprints_meet(box, other, reach)) continue;
                // Of the bins that both touch it counts in the first.
                const auto own = range(other, 0);
                if (bin == index(std::max(around.i0, own.i0), std::max(around.j0, own.j0))) use(facet);
            }
        });
    }

  private:
    /// Bins from (i0, j0) to (i1, j1).
    struct Range {
        std::int64_t i0, i1, j0, j1;
    };
    [[nodiscard]] Range range(const Box& box, double reach) const {
        return {along(box.low.x() - reach - low_.x(), nx_), along(box.high.x() + reach - low_.x(), nx_),
                along(box.low.y() - reach - low_.y(), ny_), along(box.high.y() + reach - low_.y(), ny_)};
    }
    template <class Use>
    void visit(const Range& range, Use use) const {
        for (auto j = range.j0; j <= range.j1; ++j)
            for (auto i = range.i0; i <= range.i1; ++i) use(index(i, j));
    }
    [[nodiscard]] std::size_t index(std::int64_t i, std::int64_t j) const { return static_cast<std::size_t>(j * nx_ + i); }
    // Fragments can fly far: past 4096 bins a side the last bin takes the rest.
    [[nodiscard]] std::int64_t count(double extent) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::min(extent / size_, 4096.0)) + 1, 1, 4096);
    }
    [[nodiscard]] std::int64_t along(double offset, std::int64_t n) const {
        return static_cast<std::int64_t>(std::clamp(offset / size_, 0.0, static_cast<double>(n - 1)));
    }

    const std::vector<Box>& boxes_;
    double size_;
    Vec3 low_ = Vec3::Constant(1e300);
    std::int64_t nx_ = 1, ny_ = 1;
    std::vector<std::int32_t> first_, listed_;  ///< of each bin: its facets
};

}  // namespace

Candidates find_candidates(const Surface& surface, std::span<const Vec3> x, double reach) {
    std::vector<Box> boxes;
    boxes.reserve(surface.facets.size());
    std::vector<std::vector<std::int32_t>> by_ply(surface.plies.size());
    double size = reach;
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
        boxes.push_back(Box::around(surface.facets[f], x));
        by_ply[static_cast<std::size_t>(surface.facets[f].ply)].push_back(static_cast<std::int32_t>(f));
    }
    // Bins of about the mean facet size keep the lists short on graded meshes.
    double mean = 0;
    for (const auto& box : boxes) mean += (box.high - box.low).head<2>().maxCoeff();
    if (!boxes.empty()) size = std::max(size, mean / static_cast<double>(boxes.size()));
    std::vector<Bins> bins;
    for (const auto& facets : by_ply) bins.emplace_back(boxes, facets, size);

    Candidates candidates;
    candidates.reserve(static_cast<std::size_t>(surface.owned));
    std::vector<std::int32_t> found;
    const auto id = [&](std::int32_t f) { return surface.facets[static_cast<std::size_t>(f)].id; };
    const auto by_id = [&](std::int32_t a, std::int32_t b) {
        const bool same_side = (a < surface.owned) == (b < surface.owned);  // where local order is that of the ids
        return same_side ? a < b : id(a) < id(b);
    };
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        const auto& box = boxes[static_cast<std::size_t>(f)];
        bool look_behind = surface.alive[static_cast<std::size_t>(f)] != 0;
        for (auto ply = static_cast<std::size_t>(facet.ply) + 1; ply < surface.plies.size() && look_behind; ++ply) {
            found.clear();
            bins[ply].find(box, reach, [&](std::int32_t other) { found.push_back(other); });
            std::ranges::sort(found, by_id);
            look_behind = false;
            for (const auto other : found) {
                if (surface.alive[static_cast<std::size_t>(other)])
                    candidates.add(other);
                else
                    look_behind = true;
            }
        }
        candidates.end_list();
    }
    candidates.shrink_to_fit();
    return candidates;
}

}  // namespace weavefront::contact
