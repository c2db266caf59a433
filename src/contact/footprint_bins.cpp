#include "weavefront/contact/footprint_bins.hpp"

#include <algorithm>
#include <numeric>

namespace weavefront::contact {

namespace {

// Fragments can fly far. Past this number of bins along an axis the last bin takes all others.
constexpr double most_bins = 4096;

std::int64_t bin_count(double extent, double size) {
    return static_cast<std::int64_t>(std::clamp(extent / size, 0.0, most_bins - 1)) + 1;
}

std::int64_t bin_of(double offset, double size, std::int64_t bins) {
    return static_cast<std::int64_t>(std::clamp(offset / size, 0.0, static_cast<double>(bins - 1)));
}

std::vector<std::int32_t> all_of(std::span<const Footprint> footprints) {
    std::vector<std::int32_t> indices(footprints.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

}  // namespace

FootprintBins::FootprintBins(std::span<const Footprint> footprints, double reach)
    : FootprintBins(footprints, all_of(footprints), reach) {}

FootprintBins::FootprintBins(std::span<const Footprint> footprints, std::span<const std::int32_t> chosen,
                             double reach)
    : footprints_(footprints) {
    if (chosen.empty()) return;
    const auto footprint_of = [&](std::int32_t f) -> const Footprint& {
        return footprints[static_cast<std::size_t>(f)];
    };
    double sum = 0;
    for (const auto f : chosen) {
        const auto& footprint = footprint_of(f);
        all_.include(footprint);
        sum += std::max(footprint.x_high - footprint.x_low, footprint.y_high - footprint.y_low);
    }
    const double size = std::max(reach, sum / static_cast<double>(chosen.size()));
    if (size > 0) size_ = size;
    nx_ = bin_count(all_.x_high - all_.x_low, size_);
    ny_ = bin_count(all_.y_high - all_.y_low, size_);
    bins_ = {static_cast<std::size_t>(nx_ * ny_), [&](const auto& use) {
                 for (const auto f : chosen) {
                     const auto own = bins_touched(footprint_of(f), 0);
                     for (auto j = own.j0; j <= own.j1; ++j)
                         for (auto i = own.i0; i <= own.i1; ++i)
                             use(j * nx_ + i, Entry{f, i == own.i0, j == own.j0});
                 }
             }};
}

FootprintBins::Range FootprintBins::bins_touched(const Footprint& of, double reach) const {
    return {bin_of(of.x_low - reach - all_.x_low, size_, nx_),
            bin_of(of.x_high + reach - all_.x_low, size_, nx_),
            bin_of(of.y_low - reach - all_.y_low, size_, ny_),
            bin_of(of.y_high + reach - all_.y_low, size_, ny_)};
}

}  // namespace weavefront::contact
