#include "weavefront/solver/step_bound.hpp"

#include <algorithm>
#include <array>

namespace weavefront::solver {

namespace {

// Packing builds up within some ten steps.
constexpr std::int64_t steps_between_bounds = 5;

/// The largest frequencies of all elements. @note Collective
shell::Frequencies<double> largest_frequencies(const Model& model, const parallel::Communicator& comm) {
    std::array<double, 3> largest{};
    for (const auto& group : model.groups) {
        const auto of_group = group->frequencies();
        largest = {std::max(largest[0], of_group.in_plane), std::max(largest[1], of_group.out_of_plane),
                   std::max(largest[2], of_group.hourglass)};
    }
    comm.max(largest);
    return {largest[0], largest[1], largest[2]};
}

}  // namespace

StepBound::StepBound(const scene::Scene& scene, const mesh::Panel& panel) : contact_(contact_modes(scene)) {
    if (TightStepBound::applies_to(scene)) tight_.emplace(scene, panel);
}

double StepBound::frequency_squared(const Model& model, std::span<const contact::PairForce> pairs,
                                    const parallel::Communicator& comm) {
    constexpr double any_angle = 1;
    const auto fabric = largest_frequencies(model, comm);
    const double bound =
        tight_ ? tight_->frequency_squared(model, fabric, pairs, comm)
               : damped_frequency_squared(fabric.in_plane, fabric.out_of_plane, contact_, any_angle);
    return shell::rounded_up(bound);
}

std::int64_t StepBound::steps_to_next() const {
    return tight_ && tight_->is_monitored() ? 2 * steps_between_bounds : steps_between_bounds;
}

void StepBound::set_triggers(Model& model) const {
    if (tight_) tight_->set_triggers(model);
}

}  // namespace weavefront::solver
