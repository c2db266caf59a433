#include "weavefront/solver/load_watch.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "weavefront/parallel/all_to_all.hpp"
#include "weavefront/parallel/on_root.hpp"

namespace weavefront::solver {

namespace {

// Costs are compared as integers: a column of average cost gets so much.
constexpr double average_weight = 1000;

// Of seeds of METIS.
constexpr int tries = 4;

/// Elements of a column that contact remembers something of.
struct ColumnLoad {
    std::int32_t column, touching;
};

std::vector<ColumnLoad> column_loads(const Simulation& simulation) {
    const auto& model = simulation.model();
    const auto columns = simulation.panel().columns();
    std::vector<ColumnLoad> loads;
    for (std::size_t e = 0; e < model.global.element_ids.size(); ++e)
        loads.push_back({static_cast<std::int32_t>(model.global.element_ids[e] % columns),
                         model.touches(static_cast<std::int32_t>(e)) ? 1 : 0});
    std::ranges::stable_sort(loads, {}, &ColumnLoad::column);
    std::vector<ColumnLoad> merged;
    for (const auto& load : loads)
        if (!merged.empty() && merged.back().column == load.column)
            merged.back().touching += load.touching;
        else
            merged.push_back(load);
    return merged;
}

/// What the columns of all ranks have to do now.
struct Loads {
    partition::Decomposition present;
    std::vector<std::int32_t> touching, in_zone;  ///< elements of each column
};

Loads loads_of(const mesh::Panel& panel, const std::vector<std::vector<ColumnLoad>>& by_rank,
               const std::vector<double>& distances, double radius) {
    const auto columns = static_cast<std::size_t>(panel.columns());
    Loads loads{{static_cast<int>(by_rank.size()), std::vector<std::int32_t>(columns)},
                std::vector<std::int32_t>(columns),
                {}};
    for (std::size_t rank = 0; rank < by_rank.size(); ++rank)
        for (const auto& load : by_rank[rank]) {
            loads.present.owner[static_cast<std::size_t>(load.column)] = static_cast<std::int32_t>(rank);
            loads.touching[static_cast<std::size_t>(load.column)] = load.touching;
        }
    for (const double distance : distances)
        loads.in_zone.push_back(distance < radius ? static_cast<std::int32_t>(panel.plies.size()) : 0);
    return loads;
}

/// Cost of each column. Half of the time of contact is charged to what touches, half to what is near enough.
std::vector<std::int32_t> costs_of(const Loads& loads, double elements, double contact) {
    const auto sum = [](const std::vector<std::int32_t>& values) {
        return std::accumulate(values.begin(), values.end(), std::int64_t{0});
    };
    const auto touching = static_cast<double>(sum(loads.touching)),
               in_zone = static_cast<double>(sum(loads.in_zone));
    const auto columns = static_cast<double>(loads.touching.size());
    const double share = touching > 0 && in_zone > 0 ? 0.5 : 1;
    std::vector<std::int32_t> costs;
    for (std::size_t c = 0; c < loads.touching.size(); ++c) {
        double seconds = elements / columns;
        if (touching > 0) seconds += share * contact * loads.touching[c] / touching;
        if (in_zone > 0) seconds += share * contact * loads.in_zone[c] / in_zone;
        costs.push_back(std::max(
            1, static_cast<std::int32_t>(seconds * columns / (elements + contact) * average_weight)));
    }
    return costs;
}

/// The best of some decompositions that share out columns, what touches and what is near, each on its own;
/// without owners where none promises to win back more than `limit`.
Rebalancing decomposed(const mesh::Panel& panel, const Loads& loads, const std::vector<std::int32_t>& costs,
                       double limit) {
    std::vector<std::vector<std::int32_t>> shares(1, std::vector<std::int32_t>(costs.size(), 1));
    for (const auto* share : {&loads.touching, &loads.in_zone})
        if (std::ranges::any_of(*share, [](std::int32_t elements) { return elements > 0; }))
            shares.push_back(*share);
    const double now = partition::imbalance(loads.present, costs);
    Rebalancing best{{loads.present.parts, {}}, 0, now - limit};
    for (int seed = 1; seed <= tries; ++seed) {
        auto next = partition::decompose(panel, shares, loads.present.parts, seed);
        const double predicted = partition::imbalance(next, costs);
        if (predicted >= best.predicted) continue;
        best.predicted = predicted;
        best.decomposition = std::move(next);
    }
    return best;
}

}  // namespace

LoadWatch::LoadWatch(const scene::Scene& scene, double limit) : limit_(limit), zone_(scene) {}

std::optional<Rebalancing> LoadWatch::look(const Simulation& simulation, const parallel::Communicator& comm) {
    if (comm.size() == 1 || simulation.steps() % window != 0) return {};
    const auto& seconds = simulation.seconds();
    const double elements = seconds[static_cast<std::size_t>(Phase::elements)] -
                            std::exchange(elements_, seconds[static_cast<std::size_t>(Phase::elements)]);
    const double contact = seconds[static_cast<std::size_t>(Phase::contact)] -
                           std::exchange(contact_, seconds[static_cast<std::size_t>(Phase::contact)]);
    struct Load {
        double elements, contact;
    };
    Load sum{};
    double slowest = 0;
    for (const auto& load : parallel::all_gather(comm, Load{elements, contact})) {
        sum = {sum.elements + load.elements, sum.contact + load.contact};
        slowest = std::max(slowest, load.elements + load.contact);
    }
    const double measured = slowest * comm.size() / (sum.elements + sum.contact);
    worst_ = std::max(worst_, measured);
    above_ = measured > 1 + limit_ ? above_ + 1 : 0;
    if (above_ < windows_above) return {};
    above_ = 0;

    std::vector<std::vector<ColumnLoad>> outgoing(static_cast<std::size_t>(comm.size()));
    outgoing[0] = column_loads(simulation);
    const auto by_rank = parallel::all_to_all(comm, outgoing);
    Rebalancing rebalancing{{comm.size(), {}}, 0, 0};
    parallel::on_root(comm, [&] {
        const auto& panel = simulation.panel();
        const auto loads = loads_of(panel, by_rank, zone_.distances(panel), zone_.radius(simulation.time()));
        rebalancing = decomposed(panel, loads, costs_of(loads, sum.elements, sum.contact), limit_);
    });
    comm.broadcast(rebalancing.decomposition.owner);
    rebalancing.measured = measured;
    rebalancing.predicted = comm.max(rebalancing.predicted);
    if (rebalancing.decomposition.owner.empty()) return {};
    return rebalancing;
}

}  // namespace weavefront::solver
