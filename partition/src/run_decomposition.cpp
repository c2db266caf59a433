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

// Few parts can be balanced down to the columns under the projectile. With many parts, each ring needs enough
// columns for all of them.
constexpr int few_parts = 8;
constexpr std::size_t rings_of_few = 8, rings_of_many = 5;

// With more parts, METIS takes longer for the rings than they save, and parts get too few columns of each
// ring.
constexpr int most_parts_with_rings = 256;

// The number of seeds tried is limited to some tenths of a second. METIS bisects all columns about
// log2(parts) times.
constexpr double most_seeds = 40, columns_bisected = 64'000;

// Rings are balanced at every time, whatever contact costs. Balance in the mean relies on the cost model, so
// it must win by the error of the model.
constexpr double model_error = 0.1;

/// Loads to share: the mean cost of columns over the run, and rings of the columns that contact reaches. Each
/// ring has as many columns as all rings within it, because contact lasts longest in the middle.
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
        static_cast<std::int64_t>(rings) * parts;  // a part needs at least one column of each ring
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
