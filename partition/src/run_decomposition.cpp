#include "weavefront/partition/run_decomposition.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "weavefront/partition/contact_zone.hpp"
#include "weavefront/partition/cost.hpp"
#include "weavefront/partition/forecast.hpp"

namespace weavefront::partition {

namespace {

constexpr std::size_t rings = 5;

// Beyond, METIS takes longer for the rings than they save, and parts get too few columns of each.
constexpr int most_parts_with_rings = 256;

// METIS is tried with different seeds as long as that takes no more than a tenth of a second or so.
constexpr std::int64_t most_seeds = 8, columns_tried = 16'000;

/// All columns, and rings of equally many of those that contact reaches during the run.
std::vector<std::vector<std::int32_t>> shares(const scene::Scene& scene, const mesh::Panel& panel) {
    const ContactZone zone(scene);
    const auto distances = zone.distances(panel);
    auto reached = distances;
    std::erase_if(reached, [last = zone.radius(scene.time.end)](double distance) { return distance >= last; });
    std::ranges::sort(reached);
    std::vector<std::vector<std::int32_t>> shares(1, std::vector<std::int32_t>(distances.size(), 1));
    for (std::size_t ring = 0; ring < rings && !reached.empty(); ++ring) {
        const auto low = reached[ring * reached.size() / rings], high = reached[(ring + 1) * reached.size() / rings - 1];
        auto& share = shares.emplace_back();
        for (const double distance : distances) share.push_back(distance >= low && distance <= high ? 1 : 0);
    }
    return shares;
}

}  // namespace

Decomposition decompose_for_run(const scene::Scene& scene, const mesh::Panel& panel, int parts, double ghost_reach) {
    auto best = decompose(panel, column_costs(panel, scene), parts);
    const auto sets = shares(scene, panel);
    if (parts == 1 || parts > most_parts_with_rings || sets.size() == 1) return best;
    double least = forecast(scene, panel, best, ghost_reach, committed_machine()).seconds;
    const auto seeds = static_cast<int>(std::clamp(columns_tried / panel.columns(), std::int64_t{1}, most_seeds));
    for (int seed = 1; seed <= seeds; ++seed) {
        auto other = decompose(panel, sets, parts, seed);
        const double seconds = forecast(scene, panel, other, ghost_reach, committed_machine()).seconds;
        if (seconds >= least) continue;
        least = seconds;
        best = std::move(other);
    }
    return best;
}

}  // namespace weavefront::partition
