#include "weavefront/solver/load_watch.hpp"

#include <algorithm>
#include <utility>

#include "weavefront/parallel/all_to_all.hpp"

namespace weavefront::solver {

namespace {

// METIS weighs in integers: a column of average cost gets so much.
constexpr double average_weight = 1000;

struct ColumnCost {
    std::int32_t column, rank;
    double seconds;
};

/// Cost of this rank's columns over the last window.
/// @param element, touching seconds of an element, and what one in contact takes more
std::vector<ColumnCost> column_costs(const Simulation& simulation, int rank, double element, double touching) {
    const auto& model = simulation.model();
    const auto columns = simulation.panel().columns();
    std::vector<ColumnCost> costs;
    for (std::size_t e = 0; e < model.global.element_ids.size(); ++e) {
        const auto column = static_cast<std::int32_t>(model.global.element_ids[e] % columns);
        costs.push_back({column, rank, element + (model.touches(static_cast<std::int32_t>(e)) ? touching : 0)});
    }
    std::ranges::stable_sort(costs, {}, &ColumnCost::column);
    std::vector<ColumnCost> merged;
    for (const auto& cost : costs)
        if (!merged.empty() && merged.back().column == cost.column)
            merged.back().seconds += cost.seconds;
        else
            merged.push_back(cost);
    return merged;
}

/// On rank 0: the decomposition for these costs, where it promises less than the present one; else none of its owners.
Rebalancing decomposed(const mesh::Panel& panel, const std::vector<std::vector<ColumnCost>>& costs, int ranks) {
    double total = 0;
    for (const auto& of_rank : costs)
        for (const auto& cost : of_rank) total += cost.seconds;
    const double unit = total / static_cast<double>(panel.columns()) / average_weight;
    std::vector<std::int32_t> weights(static_cast<std::size_t>(panel.columns()), 1);
    partition::Decomposition present{ranks, std::vector<std::int32_t>(weights.size())};
    for (const auto& of_rank : costs)
        for (const auto& cost : of_rank) {
            weights[static_cast<std::size_t>(cost.column)] = std::max(1, static_cast<std::int32_t>(cost.seconds / unit));
            present.owner[static_cast<std::size_t>(cost.column)] = cost.rank;
        }
    auto next = partition::decompose(panel, weights, ranks);
    const double now = partition::imbalance(present, weights);
    const double predicted = partition::imbalance(next, weights);
    if (predicted >= now) next.owner.clear();
    return {std::move(next), 0, predicted};
}

}  // namespace

std::optional<Rebalancing> LoadWatch::look(const Simulation& simulation, const parallel::Communicator& comm) {
    if (comm.size() == 1 || simulation.steps() % window != 0) return {};
    const auto& seconds = simulation.seconds();
    const double elements =
        seconds[static_cast<std::size_t>(Phase::elements)] - std::exchange(elements_, seconds[static_cast<std::size_t>(Phase::elements)]);
    const double contact =
        seconds[static_cast<std::size_t>(Phase::contact)] - std::exchange(contact_, seconds[static_cast<std::size_t>(Phase::contact)]);
    struct Load {
        double elements, contact, count, touching;
    };
    Load local{elements, contact, static_cast<double>(simulation.model().surface.owned), 0};
    for (std::int32_t e = 0; e < simulation.model().surface.owned; ++e) local.touching += simulation.model().touches(e);
    Load sum{};
    double slowest = 0;
    for (const auto& load : parallel::all_gather(comm, local)) {
        sum = {sum.elements + load.elements, sum.contact + load.contact, sum.count + load.count, sum.touching + load.touching};
        slowest = std::max(slowest, load.elements + load.contact);
    }
    const double measured = slowest * comm.size() / (sum.elements + sum.contact);
    above_ = measured > 1 + limit_ ? above_ + 1 : 0;
    if (above_ < windows_above) return {};
    above_ = 0;

    std::vector<std::vector<ColumnCost>> outgoing(static_cast<std::size_t>(comm.size()));
    outgoing[0] = column_costs(simulation, comm.rank(), sum.elements / sum.count, sum.contact / std::max(sum.touching, 1.0));
    const auto costs = parallel::all_to_all(comm, outgoing);
    Rebalancing rebalancing{{comm.size(), {}}, 0, 0};
    if (comm.rank() == 0) rebalancing = decomposed(simulation.panel(), costs, comm.size());
    comm.broadcast(rebalancing.decomposition.owner);
    rebalancing.measured = measured;
    rebalancing.predicted = comm.max(rebalancing.predicted);
    if (rebalancing.decomposition.owner.empty()) return {};
    return rebalancing;
}

}  // namespace weavefront::solver
