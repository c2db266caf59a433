#include "weavefront/partition/decomposition.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace weavefront::partition {

namespace {

struct Graph {
    std::vector<idx_t> first{0};  ///< of each vertex's neighbours
    std::vector<idx_t> neighbours;
};

/// Columns are neighbours when their footprints share an edge.
Graph column_graph(const mesh::Panel& panel) {
    Graph graph;
    const auto nx = panel.columns_x(), ny = panel.columns_y();
    for (std::int64_t j = 0; j < ny; ++j)
        for (std::int64_t i = 0; i < nx; ++i) {
            const auto column = j * nx + i;
            if (j > 0) graph.neighbours.push_back(static_cast<idx_t>(column - nx));
            if (i > 0) graph.neighbours.push_back(static_cast<idx_t>(column - 1));
            if (i + 1 < nx) graph.neighbours.push_back(static_cast<idx_t>(column + 1));
            if (j + 1 < ny) graph.neighbours.push_back(static_cast<idx_t>(column + nx));
            graph.first.push_back(static_cast<idx_t>(graph.neighbours.size()));
        }
    return graph;
}

/// METIS may leave parts empty when there are nearly as many parts as columns: each takes the last column of the fullest part.
void fill_empty_parts(Decomposition& decomposition) {
    std::vector<std::vector<std::size_t>> columns(static_cast<std::size_t>(decomposition.parts));
    for (std::size_t c = 0; c < decomposition.owner.size(); ++c) columns[static_cast<std::size_t>(decomposition.owner[c])].push_back(c);
    const auto less_full = [&](std::size_t a, std::size_t b) {
        return columns[a].size() != columns[b].size() ? columns[a].size() < columns[b].size() : a > b;
    };
    std::vector<std::size_t> fullest, empty;
    for (std::size_t part = 0; part < columns.size(); ++part) (columns[part].empty() ? empty : fullest).push_back(part);
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

std::vector<idx_t> metis_weights(std::span<const std::int32_t> weights) {
    const auto total = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
    const auto divisor = static_cast<std::int32_t>(total / largest_total + 1);
    std::vector<idx_t> scaled;
    scaled.reserve(weights.size());
    for (const auto weight : weights) scaled.push_back(std::max(weight / divisor, 1));
    return scaled;
}

std::vector<idx_t> metis_kway(Graph& graph, std::vector<idx_t>& weights, idx_t parts) {
    auto vertices = static_cast<idx_t>(weights.size());
    idx_t constraints = 1, cut = 0;
    std::array<idx_t, METIS_NOPTIONS> options{};
    METIS_SetDefaultOptions(options.data());
    options[METIS_OPTION_SEED] = 1;
    options[METIS_OPTION_UFACTOR] = 5;  // imbalance 1.005
    std::vector<idx_t> owner(weights.size());
    const int status = METIS_PartGraphKway(&vertices, &constraints, graph.first.data(), graph.neighbours.data(), weights.data(), nullptr,
                                           nullptr, &parts, nullptr, nullptr, options.data(), &cut, owner.data());
    if (status != METIS_OK) throw std::runtime_error("METIS could not partition the target (status " + std::to_string(status) + ")");
    return owner;
}

}  // namespace

std::vector<std::int64_t> Decomposition::columns_of(int part) const {
    std::vector<std::int64_t> columns;
    for (std::size_t c = 0; c < owner.size(); ++c)
        if (owner[c] == part) columns.push_back(static_cast<std::int64_t>(c));
    return columns;
}

Decomposition decompose(const mesh::Panel& panel, std::span<const std::int32_t> weights, int parts) {
    if (parts > panel.columns())
        throw std::invalid_argument(std::to_string(parts) + " ranks for a target of " + std::to_string(panel.columns()) +
                                    " columns: use at most that many");
    Decomposition decomposition{parts, std::vector<std::int32_t>(static_cast<std::size_t>(panel.columns()), 0)};
    if (parts == 1) return decomposition;
    auto graph = column_graph(panel);
    auto scaled = metis_weights(weights);
    const auto owner = metis_kway(graph, scaled, parts);
    decomposition.owner.assign(owner.begin(), owner.end());
    fill_empty_parts(decomposition);
    return decomposition;
}

std::int64_t cut_edges(const Decomposition& decomposition, const mesh::Panel& panel) {
    const auto nx = panel.columns_x(), ny = panel.columns_y();
    const auto owner = [&](std::int64_t i, std::int64_t j) { return decomposition.owner[static_cast<std::size_t>(j * nx + i)]; };
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
    for (std::size_t c = 0; c < weights.size(); ++c) load[static_cast<std::size_t>(decomposition.owner[c])] += weights[c];
    return *std::max_element(load.begin(), load.end()) * decomposition.parts / std::accumulate(load.begin(), load.end(), 0.0);
}

}  // namespace weavefront::partition
