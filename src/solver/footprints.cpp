#include "footprints.hpp"

#include <algorithm>

namespace weavefront::solver {

namespace {

// Fragments can fly far: past so many bins a side the outermost take the rest.
constexpr double most_bins = 1024;

std::int64_t bin_of(double offset, std::int64_t bins) {
    return static_cast<std::int64_t>(std::clamp(offset, 0.0, static_cast<double>(bins - 1)));
}

}  // namespace

FootprintBins::FootprintBins(std::vector<Footprint> footprints, double reach)
    : footprints_(std::move(footprints)), reach_(reach) {
    if (footprints_.empty()) return;
    for (const auto& footprint : footprints_) {
        all_.include(footprint);
        size_ += std::max(footprint.x_high - footprint.x_low, footprint.y_high - footprint.y_low);
    }
    size_ = std::max(size_ / static_cast<double>(footprints_.size()), reach_);
    nx_ = 1 + static_cast<std::int64_t>(std::min((all_.x_high - all_.x_low + 2 * reach_) / size_, most_bins));
    ny_ = 1 + static_cast<std::int64_t>(std::min((all_.y_high - all_.y_low + 2 * reach_) / size_, most_bins));
    const auto for_each_listing = [&](auto use) {
        for (std::size_t f = 0; f < footprints_.size(); ++f) {
            auto wide = footprints_[f];
            wide.x_low -= reach_, wide.x_high += reach_, wide.y_low -= reach_, wide.y_high += reach_;
            const auto [i0, i1, j0, j1] = touched(wide);
            for (auto j = j0; j <= j1; ++j)
                for (auto i = i0; i <= i1; ++i)
                    use(static_cast<std::size_t>(j * nx_ + i), static_cast<std::int32_t>(f));
        }
    };
    first_.assign(static_cast<std::size_t>(nx_ * ny_) + 2, 0);
    for_each_listing([&](std::size_t bin, std::int32_t) { ++first_[bin + 2]; });
    for (std::size_t bin = 2; bin < first_.size(); ++bin) first_[bin] += first_[bin - 1];
    listed_.resize(first_.back());
    for_each_listing(
        [&](std::size_t bin, std::int32_t footprint) { listed_[first_[bin + 1]++] = footprint; });
}

bool FootprintBins::near(const Footprint& other, double reach) const {
    if (!all_.near(other, reach)) return false;
    const auto [i0, i1, j0, j1] = touched(other);
    for (auto j = j0; j <= j1; ++j)
        for (auto i = i0; i <= i1; ++i) {
            const auto bin = static_cast<std::size_t>(j * nx_ + i);
            for (auto k = first_[bin]; k < first_[bin + 1]; ++k)
                if (footprints_[static_cast<std::size_t>(listed_[k])].near(other, reach)) return true;
        }
    return false;
}

FootprintBins::Bins FootprintBins::touched(const Footprint& footprint) const {
    const double x = all_.x_low - reach_, y = all_.y_low - reach_;
    return {bin_of((footprint.x_low - x) / size_, nx_), bin_of((footprint.x_high - x) / size_, nx_),
            bin_of((footprint.y_low - y) / size_, ny_), bin_of((footprint.y_high - y) / size_, ny_)};
}

}  // namespace weavefront::solver
