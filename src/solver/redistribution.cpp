#include "weavefront/solver/redistribution.hpp"

#include <algorithm>
#include <span>

#include "element_state.hpp"
#include "weavefront/parallel/all_to_all.hpp"
#include "weavefront/state/record.hpp"

namespace weavefront::solver {

namespace {

/// The id of an element (below 2^53, so a double holds it), its corners' motion and its state.
std::vector<double> record_of(Model& model, std::int32_t element) {
    const auto e = static_cast<std::size_t>(element);
    std::vector<double> record{static_cast<double>(model.global.element_ids[e])};
    state::RecordWriter archive(record);
    for (const auto node : model.surface.facets[e].nodes)
        visit_node(archive, model, static_cast<std::size_t>(node));
    visit_element(archive, model, element);
    return record;
}

/// Takes up the first of some records. @return those after it
std::span<const double> take_record(std::span<const double> records, Model& model) {
    const auto& ids = model.global.element_ids;
    const auto e = static_cast<std::size_t>(
        std::ranges::lower_bound(ids, static_cast<std::int64_t>(records[0])) - ids.begin());
    state::RecordReader archive(records.subspan(1));
    for (const auto node : model.surface.facets[e].nodes)
        visit_node(archive, model, static_cast<std::size_t>(node));
    visit_element(archive, model, static_cast<std::int32_t>(e));
    return archive.rest();
}

}  // namespace

Model redistribute(const scene::Scene& scene, const mesh::Panel& panel,
                   const partition::Decomposition& decomposition, Model& model,
                   const parallel::Communicator& comm) {
    auto next = build_model(scene, panel, decomposition, comm);
    for (std::size_t p = 0; p < model.projectiles.size(); ++p) {
        next.projectiles[p].body = model.projectiles[p].body;
        next.projectiles[p].on_frame = model.projectiles[p].on_frame;
    }
    std::vector<std::vector<double>> leaving(static_cast<std::size_t>(comm.size()));
    for (std::int32_t e = 0; e < model.surface.owned; ++e) {
        const auto column =
            static_cast<std::size_t>(model.global.element_ids[static_cast<std::size_t>(e)] % panel.columns());
        const auto record = record_of(model, e);
        const auto owner = decomposition.owner[column];
        if (owner == comm.rank()) {
            take_record(record, next);
            continue;
        }
        auto& to = leaving[static_cast<std::size_t>(owner)];
        to.insert(to.end(), record.begin(), record.end());
    }
    for (const auto& arriving : parallel::all_to_all(comm, leaving))
        for (std::span<const double> rest = arriving; !rest.empty();) rest = take_record(rest, next);
    return next;
}

}  // namespace weavefront::solver
