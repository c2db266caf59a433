#include "weavefront/contact/candidates.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

namespace {

/// Uniform bins over x and y; a facet is listed in every bin that its footprint touches.
class Bins {
  public:
    Bins(const std::vector<Box>& boxes, const std::vector<std::int32_t>& facets, double size) : size_(size) {
        Vec3 high = Vec3::Constant(-1e300);
        for (const auto f : facets) {
            low_ = low_.cwiseMin(boxes[static_cast<std::size_t>(f)].low);
            high = high.cwiseMax(boxes[static_cast<std::size_t>(f)].high);
        }
        nx_ = count(high.x() - low_.x());
        ny_ = count(high.y() - low_.y());
        bins_.resize(static_cast<std::size_t>(nx_ * ny_));
        for (const auto f : facets) visit(boxes[static_cast<std::size_t>(f)], 0, [&](auto& bin) { bin.push_back(f); });
    }

    /// Calls `use` with each bin that the footprint of a box, widened by `reach`, touches.
    template <class Use>
    void visit(const Box& box, double reach, Use use) {
        const auto i0 = index(box.low.x() - reach - low_.x(), nx_), i1 = index(box.high.x() + reach - low_.x(), nx_);
        const auto j0 = index(box.low.y() - reach - low_.y(), ny_), j1 = index(box.high.y() + reach - low_.y(), ny_);
        for (auto j = j0; j <= j1; ++j)
            for (auto i = i0; i <= i1; ++i) use(bins_[static_cast<std::size_t>(j * nx_ + i)]);
    }

  private:
    // Fragments can fly far: past 4096 bins a side the last bin takes the rest.
    [[nodiscard]] std::int64_t count(double extent) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::min(extent / size_, 4096.0)) + 1, 1, 4096);
    }
    [[nodiscard]] std::int64_t index(double offset, std::int64_t n) const {
        return static_cast<std::int64_t>(std::clamp(offset / size_, 0.0, static_cast<double>(n - 1)));
    }

    double size_;
    Vec3 low_ = Vec3::Constant(1e300);
    std::int64_t nx_ = 1, ny_ = 1;
    std::vector<std::vector<std::int32_t>> bins_;
};

bool footprints_meet(const Box& a, const Box& b, double reach) {
    return a.low.x() <= b.high.x() + reach && a.high.x() >= b.low.x() - reach && a.low.y() <= b.high.y() + reach &&
           a.high.y() >= b.low.y() - reach;
}

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
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        const auto& facet = surface.facets[static_cast<std::size_t>(f)];
        const auto& box = boxes[static_cast<std::size_t>(f)];
        bool look_behind = surface.alive[static_cast<std::size_t>(f)] != 0;
        for (auto ply = static_cast<std::size_t>(facet.ply) + 1; ply < surface.plies.size() && look_behind; ++ply) {
            found.clear();
            bins[ply].visit(box, reach, [&](const auto& bin) {
                for (const auto other : bin)
                    if (footprints_meet(box, boxes[static_cast<std::size_t>(other)], reach)) found.push_back(other);
            });
            std::ranges::sort(found, {}, [&](std::int32_t other) { return surface.facets[static_cast<std::size_t>(other)].id; });
            found.erase(std::unique(found.begin(), found.end()), found.end());
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
