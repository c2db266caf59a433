#include <string>

#include "element_state.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver {

template <class Archive>
void Simulation::visit_values(Archive& archive) {
    clock_.state(archive);
    archive("clock.next_adaptation", next_adaptation_);
    for (std::size_t p = 0; p < shots_.size(); ++p) {
        model_.projectiles[p].state(archive, name_of_projectile(p));
        shots_[p].state(archive, name_of_projectile(p));
    }
    if (shots_.size() > 1) projectile_overlap_.state(archive);
    sliding_[of_projectile].state(archive, "sliding.projectile");
    sliding_[of_plies].state(archive, "sliding.plies");
    sliding_[of_frame].state(archive, "sliding.frame");
    archive("search.any_eroded", search_.any_eroded);
    ledger_.state(archive);
    counts_.state(archive);
    step_bound_.state(archive);
}

SavedState Simulation::save() {
    counts_.deepest = deepest();
    SavedState saved;
    state::ValueWriter values(saved.values, comm_);
    visit_values(values);

    for (std::size_t n = 0; n < model_.nodes.ids.size(); ++n)
        if (model_.nodes.owned[n]) saved.nodes.ids.push_back(model_.nodes.ids[n]);
    state::ColumnWriter nodes(saved.nodes);
    for (std::size_t n = 0, item = 0; n < model_.nodes.ids.size(); ++n) {
        if (!model_.nodes.owned[n]) continue;
        nodes.start(item++);
        visit_node(nodes, model_, n);
    }
    saved.elements.ids = model_.global.element_ids;
    state::ColumnWriter elements(saved.elements);
    for (std::size_t e = 0; e < saved.elements.ids.size(); ++e) {
        elements.start(e);
        visit_element(elements, model_, static_cast<std::int32_t>(e));
    }
    return saved;
}

void Simulation::read_state(SavedState& saved) {
    state::ValueReader values(saved.values, comm_);
    visit_values(values);
    state::ColumnReader nodes(saved.nodes);
    for (std::size_t n = 0; n < model_.nodes.ids.size(); ++n) {
        nodes.start(n);
        visit_node(nodes, model_, n);
    }
    nodes.finish();
    state::ColumnReader elements(saved.elements);
    for (std::size_t e = 0; e < model_.global.element_ids.size(); ++e) {
        elements.start(e);
        visit_element(elements, model_, static_cast<std::int32_t>(e));
    }
    elements.finish();
}

void Simulation::restore(SavedState saved) {
    std::string failure;
    try {
        read_state(saved);
    } catch (const state::Mismatch& mismatch) {
        failure = mismatch.what();
    }
    failure = parallel::first_failure(comm_, failure);
    if (!failure.empty()) throw state::Mismatch(failure);
    saved = {};
    model_.ghosts = {};  // which have moved, too
    follow_model();
    update_candidates();
}

}  // namespace weavefront::solver
