#include "weavefront/partition/run_decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "weavefront/partition/contact_zone.hpp"
#include "weavefront/partition/cost.hpp"
#include "weavefront/partition/forecast.hpp"

namespace weavefront::partition {

namespace {

// Few parts can be balanced down to what lies under the projectile; with many, each ring has to have enough
// columns for all of them.
constexpr int few_parts = 8;
constexpr std::size_t rings_of_few = 8, rings_of_many = 5;

// Beyond, METIS takes longer for the rings than they save, and parts get too few columns of each.
constexpr int most_parts_with_rings = 256;

// METIS is tried with different seeds as long as that takes no more than some tenths of a second: it bisects
// all columns about as often as the number of parts has doubled.
constexpr double most_seeds = 40, columns_bisected = 64'000;

// What is balanced ring by ring is balanced at every time, whatever contact costs; what is balanced in the
// mean over the run only as far as the model is right, so it has to be better by the model's error.
constexpr double model_error = 0.1;

/// What columns cost in the mean over the run, and rings of those that contact reaches during the run: each
/// of as many columns as all within it, because contact begins in the middle and works there the longest.
std::vector<std::vector<std::int32_t>> shares(const scene::Scene& scene, const mesh::Panel& panel,
                                              std::size_t rings) {
    const ContactZone zone(scene);
    const auto distances = zone.distances(panel);
    auto reached = distances;
    std::erase_if(reached,
                  [last = zone.radius(scene.time.end)](double distance) { return distance >= last; });
    std::ranges::sort(reached);
    std::vector<std::vector<std::int32_t>> shares(1, column_costs(panel, scene));
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const auto first = ring == 0 ? 0 : reached.size() >> (rings - ring),
                   end = reached.size() >> (rings - ring - 1);
        if (first == end) continue;
        const auto low = reached[first], high = reached[end - 1];
        auto& share = shares.emplace_back();
        for (const double distance : distances) share.push_back(distance >= low && distance <= high ? 1 : 0);
    }
    return shares;
}

}  // namespace

Decomposition decompose_for_run(const scene::Scene& scene, const mesh::Panel& panel, int parts,
                                double ghost_reach) {
    auto best = decompose(panel, column_costs(panel, scene), parts);
    const auto rings = parts <= few_parts ? rings_of_few : rings_of_many;
    const auto columns_for_rings =
        static_cast<std::int64_t>(rings) * parts;  // a part needs at least one of each
    if (parts == 1 || parts > most_parts_with_rings || panel.columns() < columns_for_rings) return best;
    const auto sets = shares(scene, panel, rings);
    if (sets.size() == 1) return best;
    const auto seconds_of = [&](const Decomposition& decomposition) {
        return forecast(scene, panel, decomposition, ghost_reach, committed_machine()).seconds;
    };
    double least = (1 + model_error) * seconds_of(best);
    const double bisected = static_cast<double>(panel.columns()) * std::log2(parts);
    const auto seeds = static_cast<int>(std::clamp(columns_bisected / bisected, 1.0, most_seeds));
    for (int seed = 1; seed <= seeds; ++seed) {
        auto other = decompose(panel, sets, parts, seed);
        const double seconds = seconds_of(other);
        if (seconds >= least) continue;
        least = seconds;
        best = std::move(other);
    }
    return best;
}

}  // namespace weavefront::partition
