#include "weavefront/partition/decomposition.hpp"

#include <metis.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <numeric>
#include <stdexcept>
#include <string>

#include "silent_output.hpp"
#include "weavefront/mesh/adjacency_list.hpp"

namespace weavefront::partition {

namespace {

/// By column: the columns whose footprints share an edge with its own.
mesh::AdjacencyList<idx_t, idx_t> column_graph(const mesh::Panel& panel) {
    mesh::AdjacencyList<idx_t, idx_t> graph;
    const auto nx = panel.columns_x(), ny = panel.columns_y();
    for (std::int64_t j = 0; j < ny; ++j)
        for (std::int64_t i = 0; i < nx; ++i) {
            const auto column = j * nx + i;
            if (j > 0) graph.push_back(static_cast<idx_t>(column - nx));
            if (i > 0) graph.push_back(static_cast<idx_t>(column - 1));
            if (i + 1 < nx) graph.push_back(static_cast<idx_t>(column + 1));
            if (j + 1 < ny) graph.push_back(static_cast<idx_t>(column + nx));
            graph.end_row();
        }
    return graph;
}

/// METIS may leave parts empty when there are nearly as many parts as columns. Each empty part takes the last
/// column of the fullest part.
void fill_empty_parts(Decomposition& decomposition) {
    std::vector<std::vector<std::size_t>> columns(static_cast<std::size_t>(decomposition.parts));
    for (std::size_t c = 0; c < decomposition.owner.size(); ++c)
        columns[static_cast<std::size_t>(decomposition.owner[c])].push_back(c);
    const auto less_full = [&](std::size_t a, std::size_t b) {
        return columns[a].size() != columns[b].size() ? columns[a].size() < columns[b].size() : a > b;
    };
    std::vector<std::size_t> fullest, empty;
    for (std::size_t part = 0; part < columns.size(); ++part)
        (columns[part].empty() ? empty : fullest).push_back(part);
    std::ranges::make_heap(fullest, less_full);
    for (const auto part : empty) {
        std::ranges::pop_heap(fullest, less_full);
        auto& giving = columns[fullest.back()];
        decomposition.owner[giving.back()] = static_cast<std::int32_t>(part);
        giving.pop_back();
        std::ranges::push_heap(fullest, less_full);
    }
}

// METIS adds weights in 32 bits.
constexpr std::int64_t largest_total = std::int64_t{1} << 30;

/// Weights in 32 bits. No column weighs more than the mean of a part, since METIS would run out of columns
/// for the last parts.
std::vector<idx_t> metis_weights(std::span<const std::int32_t> weights, int parts) {
    const auto total = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
    const auto divisor = total / largest_total + 1,
               of_part = std::max(total / divisor / parts, std::int64_t{1});
    std::vector<idx_t> scaled;
    scaled.reserve(weights.size());
    for (const auto weight : weights)
        scaled.push_back(
            weight > 0 ? static_cast<idx_t>(std::clamp(weight / divisor, std::int64_t{1}, of_part)) : 0);
    return scaled;
}

/// METIS replaces the handler of SIGTERM while it works, and fails on the signal. Then it restores the
/// handler by System V's signal(), for one signal only. This class blocks SIGTERM in this thread meanwhile
/// and restores the handler as it was.
class HeldTermination {
  public:
    HeldTermination() {
        sigset_t termination;
        sigemptyset(&termination);
        sigaddset(&termination, SIGTERM);
        pthread_sigmask(SIG_BLOCK, &termination, &before_);
        sigaction(SIGTERM, nullptr, &action_);
    }
    ~HeldTermination() {
        sigaction(SIGTERM, &action_, nullptr);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    HeldTermination(const HeldTermination&) = delete;
    HeldTermination& operator=(const HeldTermination&) = delete;

  private:
    sigset_t before_{};
    struct sigaction action_ {};
};

/// Arguments in which calls of METIS differ. Weights are ordered column by column.
struct Call {
    decltype(&METIS_PartGraphKway) method;
    idx_t constraints, seed, imbalance_in_thousandths;
    std::vector<real_t> imbalances;  ///< by constraint; empty: `imbalance_in_thousandths` for all
};

Decomposition partition(const mesh::Panel& panel, std::vector<idx_t> weights, int parts, Call call) {
    Decomposition decomposition{parts,
                                std::vector<std::int32_t>(static_cast<std::size_t>(panel.columns()), 0)};
    if (parts == 1) return decomposition;
    const auto graph = column_graph(panel);
    // METIS asks for arrays that may change, but leaves the graph as it is.
    auto* const offsets = const_cast<idx_t*>(graph.offsets().data());
    auto* const neighbours = const_cast<idx_t*>(graph.items().data());
    auto vertices = static_cast<idx_t>(panel.columns());
    idx_t parts_wanted = parts, cut = 0;
    std::array<idx_t, METIS_NOPTIONS> options{};
    METIS_SetDefaultOptions(options.data());
    options[METIS_OPTION_SEED] = call.seed;
    options[METIS_OPTION_UFACTOR] = call.imbalance_in_thousandths;
    std::vector<idx_t> owner(decomposition.owner.size());
    const SilentOutput silent;
    const HeldTermination held;
    const int status =
        call.method(&vertices, &call.constraints, offsets, neighbours, weights.data(), nullptr, nullptr,
                    &parts_wanted, nullptr, call.imbalances.empty() ? nullptr : call.imbalances.data(),
                    options.data(), &cut, owner.data());
    if (status != METIS_OK)
        throw std::runtime_error("METIS could not partition the target (status " + std::to_string(status) +
                                 ")");
    decomposition.owner.assign(owner.begin(), owner.end());
    fill_empty_parts(decomposition);
    return decomposition;
}

void require_columns(const mesh::Panel& panel, int parts) {
    if (parts > panel.columns())
        throw std::invalid_argument(std::to_string(parts) + " ranks for a target of " +
                                    std::to_string(panel.columns()) + " columns: use at most that many");
}

}  // namespace

std::vector<std::int64_t> Decomposition::columns_of(int part) const {
    std::vector<std::int64_t> columns;
    for (std::size_t c = 0; c < owner.size(); ++c)
        if (owner[c] == part) columns.push_back(static_cast<std::int64_t>(c));
    return columns;
}

Decomposition decompose(const mesh::Panel& panel, std::span<const std::int32_t> weights, int parts) {
    require_columns(panel, parts);
    auto scaled = metis_weights(weights, parts);
    // If the allowed imbalance is below half of the heaviest column, METIS scatters columns to reach it.
    const auto of_part =
        static_cast<double>(std::accumulate(scaled.begin(), scaled.end(), std::int64_t{0})) / parts;
    const double in_thousandths = scaled.empty() ? 0 : 500 * *std::ranges::max_element(scaled) / of_part;
    return partition(panel, std::move(scaled), parts,
                     {METIS_PartGraphKway, 1, 1, std::max(5, static_cast<idx_t>(in_thousandths)), {}});
}

Decomposition decompose(const mesh::Panel& panel, std::span<const std::vector<std::int32_t>> shares,
                        int parts, int seed) {
    require_columns(panel, parts);
    const auto columns = static_cast<std::size_t>(panel.columns());
    std::vector<idx_t> weights(columns * shares.size());
    std::vector<real_t> imbalances;
    for (std::size_t s = 0; s < shares.size(); ++s) {
        const auto share = metis_weights(shares[s], parts);
        for (std::size_t c = 0; c < columns; ++c) weights[c * shares.size() + s] = share[c];
        const auto of_part =
            static_cast<double>(std::accumulate(share.begin(), share.end(), std::int64_t{0})) / parts;
        imbalances.push_back(
            static_cast<real_t>(1 + std::max(0.01, 0.5 * *std::ranges::max_element(share) / of_part)));
    }
    return partition(
        panel, std::move(weights), parts,
        {METIS_PartGraphRecursive, static_cast<idx_t>(shares.size()), seed, 10, std::move(imbalances)});
}

std::int64_t cut_edges(const Decomposition& decomposition, const mesh::Panel& panel) {
    const auto nx = panel.columns_x(), ny = panel.columns_y();
    const auto owner = [&](std::int64_t i, std::int64_t j) {
        return decomposition.owner[static_cast<std::size_t>(j * nx + i)];
    };
    std::int64_t cut = 0;
    for (std::int64_t j = 0; j < ny; ++j)
        for (std::int64_t i = 0; i < nx; ++i) {
            if (i + 1 < nx && owner(i, j) != owner(i + 1, j)) ++cut;
            if (j + 1 < ny && owner(i, j) != owner(i, j + 1)) ++cut;
        }
    return cut;
}

double imbalance(const Decomposition& decomposition, std::span<const std::int32_t> weights) {
    std::vector<double> load(static_cast<std::size_t>(decomposition.parts));
    for (std::size_t c = 0; c < weights.size(); ++c)
        load[static_cast<std::size_t>(decomposition.owner[c])] += weights[c];
    return *std::max_element(load.begin(), load.end()) * decomposition.parts /
           std::accumulate(load.begin(), load.end(), 0.0);
}

}  // namespace weavefront::partition
