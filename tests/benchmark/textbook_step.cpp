#include "textbook_step.hpp"

#include <algorithm>
#include <cmath>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/solver/motion.hpp"

namespace weavefront::benchmark {

namespace {

// As the solver has them: other values would be other arithmetic.
constexpr std::int32_t packs_at_once = 64;
constexpr std::int64_t steps_between_checks = 5;
constexpr double worth_raising = 1.05;

solver::Model at_rest(const scene::Scene& scene, const parallel::Communicator& comm) {
    const auto panel = mesh::make_panel(scene);
    return solver::build_model(scene, panel, solver::initial_decomposition(scene, panel, 0, comm), comm);
}

}  // namespace

TextbookStep::TextbookStep(const scene::Scene& scene, const parallel::Communicator& comm)
    : safety_(scene.time.safety), model_(at_rest(scene, comm)) {
    pack_forces_.resize(static_cast<std::size_t>(packs_at_once) * shell::forces_per_pack);
    adapt_time_step();
}

void TextbookStep::advance() {
    model_.assembly.start(model_.nodes.force);
    advance_elements();
    if (steps_ % steps_between_checks == 0) adapt_time_step();
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
    double omega_squared = 0;
    for (const auto& group : model_.groups) omega_squared = std::max(omega_squared, group->frequency_squared());
    const double bound = safety_ * 2 / std::sqrt(omega_squared);
    if (dt_ > 0 && dt_ <= bound && bound < worth_raising * dt_) return;
    dt_ = bound;
    for (const auto& group : model_.groups) group->set_time_step(dt_);
}

void TextbookStep::move_nodes() {
    solver::move_freely(model_.nodes, model_.assembly.scale(), (last_dt_ + dt_) / 2, dt_);
    last_dt_ = dt_;
}

}  // namespace weavefront::benchmark
