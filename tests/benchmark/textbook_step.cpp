#include "textbook_step.hpp"

#include <algorithm>
#include <cmath>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/solver/motion.hpp"

namespace weavefront::benchmark {

namespace {

// As the solver has them: other values would be other arithmetic.
constexpr std::int32_t packs_at_once = 64;
constexpr double worth_raising = 1.05;

solver::Model at_rest(const scene::Scene& scene, const mesh::Panel& panel,
                      const parallel::Communicator& comm) {
    return solver::build_model(scene, panel, solver::initial_decomposition(scene, panel, 0, comm), comm);
}

}  // namespace

TextbookStep::TextbookStep(const scene::Scene& scene, const parallel::Communicator& comm)
    : comm_(comm),
      safety_(scene.time.safety),
      panel_(mesh::make_panel(scene)),
      model_(at_rest(scene, panel_, comm)),
      bound_(scene, panel_) {
    pack_forces_.resize(static_cast<std::size_t>(packs_at_once) * shell::forces_per_pack);
    adapt_time_step();
}

void TextbookStep::advance() {
    model_.assembly.start(model_.nodes.force);
    advance_elements();
    const bool stiffened =
        std::ranges::any_of(model_.groups, [](const auto& group) { return group->has_stiffened(); });
    if (stiffened || steps_ >= next_adaptation_) adapt_time_step();
    move_nodes();
    ++steps_;
}

void TextbookStep::advance_elements() {
    shell::Events none;
    for (const auto& group : model_.groups)
        for (std::int32_t first = 0; first < group->packs(); first += packs_at_once) {
            const auto count = std::min(packs_at_once, group->packs() - first);
            group->advance(first, count, model_.nodes.x, pack_forces_, none);
            model_.assembly.add_packs(*group, first, count, pack_forces_, model_.nodes.force);
        }
}

void TextbookStep::adapt_time_step() {
    const double bound = safety_ * 2 / std::sqrt(bound_.frequency_squared(model_, {}, comm_));
    bound_.set_triggers(model_);
    next_adaptation_ = steps_ + bound_.steps_to_next();
    if (dt_ > 0 && dt_ <= bound && bound < worth_raising * dt_) return;
    dt_ = bound;
    for (const auto& group : model_.groups) group->set_time_step(dt_);
}

void TextbookStep::move_nodes() {
    solver::move_freely(model_.nodes, model_.assembly.scale(), (last_dt_ + dt_) / 2, dt_);
    last_dt_ = dt_;
}

}  // namespace weavefront::benchmark
