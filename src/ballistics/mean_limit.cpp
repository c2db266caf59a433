#include "weavefront/ballistics/mean_limit.hpp"

#include <algorithm>

namespace weavefront::ballistics {

namespace {

// Differences of speeds in ft/s are rounded.
constexpr double rounding = 1e-9;  // m/s

std::vector<std::size_t> indices_of(std::span<const Shot> shots, bool is_complete) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < shots.size(); ++i)
        if (shots[i].is_complete == is_complete) indices.push_back(i);
    return indices;
}

std::optional<MeanLimit> mean_of(std::span<const Shot> shots, std::size_t each) {
    const auto speed = [&](std::size_t i) { return shots[i].speed; };
    auto partial = indices_of(shots, false), complete = indices_of(shots, true);
    if (partial.size() < each || complete.size() < each) return std::nullopt;
    std::ranges::stable_sort(partial, std::ranges::greater{}, speed);
    std::ranges::stable_sort(complete, {}, speed);
    MeanLimit limit;
    limit.shots.assign(partial.begin(), partial.begin() + static_cast<std::ptrdiff_t>(each));
    limit.shots.insert(limit.shots.end(), complete.begin(),
                       complete.begin() + static_cast<std::ptrdiff_t>(each));
    std::ranges::stable_sort(limit.shots, {}, speed);
    limit.spread = speed(limit.shots.back()) - speed(limit.shots.front());
    if (limit.spread > most_spread + rounding) return std::nullopt;
    for (const std::size_t i : limit.shots) limit.v50 += speed(i) / static_cast<double>(limit.shots.size());
    return limit;
}

}  // namespace

std::optional<MeanLimit> mean_limit(std::span<const Shot> shots) {
    if (auto limit = mean_of(shots, 5)) return limit;
    return mean_of(shots, 3);
}

}  // namespace weavefront::ballistics
