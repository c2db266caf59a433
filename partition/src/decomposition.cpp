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
    std::vector<std::int64_t> count(static_cast<std::size_t>(decomposition.parts));
    for (const auto part : decomposition.owner) ++count[static_cast<std::size_t>(part)];
    for (std::size_t part = 0; part < count.size(); ++part) {
        if (count[part] > 0) continue;
        const auto fullest = static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin());
        const auto last = std::find(decomposition.owner.rbegin(), decomposition.owner.rend(), static_cast<std::int32_t>(fullest));
        *last = static_cast<std::int32_t>(part);
        --count[fullest];
        ++count[part];
    }
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
    std::vector<idx_t> metis_weights(weights.begin(), weights.end());
    const auto owner = metis_kway(graph, metis_weights, parts);
    decomposition.owner.assign(owner.begin(), owner.end());
    fill_empty_parts(decomposition);
    return decomposition;
}

Quality quality_of(const Decomposition& decomposition, const mesh::Panel& panel, std::span<const std::int32_t> weights) {
    std::vector<double> load(static_cast<std::size_t>(decomposition.parts));
    for (std::size_t c = 0; c < weights.size(); ++c) load[static_cast<std::size_t>(decomposition.owner[c])] += weights[c];
    Quality quality;
    quality.imbalance = *std::max_element(load.begin(), load.end()) * decomposition.parts / std::accumulate(load.begin(), load.end(), 0.0);
    const auto graph = column_graph(panel);
    for (std::size_t c = 0; c < weights.size(); ++c)
        for (auto k = graph.first[c]; k < graph.first[c + 1]; ++k) {
            const auto other = static_cast<std::size_t>(graph.neighbours[static_cast<std::size_t>(k)]);
            if (other > c && decomposition.owner[other] != decomposition.owner[c]) ++quality.cut_edges;
        }
    return quality;
}

}  // namespace weavefront::partition
