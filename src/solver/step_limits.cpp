#include "weavefront/solver/step_limits.hpp"

#include <cmath>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/model.hpp"
#include "weavefront/solver/step_bound.hpp"

namespace weavefront::solver {

namespace {

// What contact takes off the step without anybody noticing.
constexpr double noticeable = 1.01;

/// A scene without one of its contacts.
scene::Scene without(scene::Scene scene, StepLimit contact) {
    if (contact == StepLimit::plies) scene.contact.plies.reset();
    if (contact == StepLimit::projectile) scene.contact.projectile.reset();
    if (contact == StepLimit::frame) scene.target->frame.reset();
    return scene;
}

}  // namespace

StepLimits step_limits(const scene::Scene& scene, const mesh::Panel& panel) {
    const auto alone = parallel::Communicator::alone();
    const partition::Decomposition whole{
        1, std::vector<std::int32_t>(static_cast<std::size_t>(panel.columns()), 0)};
    const Model model = build_model(scene, panel, whole, alone);
    const auto step = [&](const scene::Scene& some) {
        return scene.time.safety * 2 / std::sqrt(StepBound(some, panel).frequency_squared(model, {}, alone));
    };
    auto free = scene;
    StepLimits limits{.time_step = step(scene)};
    double largest = 0;
    for (const auto contact : {StepLimit::plies, StepLimit::projectile, StepLimit::frame}) {
        free = without(free, contact);
        const double rest = step(without(scene, contact));
        if (rest <= largest) continue;
        largest = rest;
        limits.limit = contact;
    }
    limits.of_elements = step(free);
    if (limits.of_elements <= noticeable * limits.time_step) limits.limit = StepLimit::elements;
    return limits;
}

}  // namespace weavefront::solver
