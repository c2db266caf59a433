#include "weavefront/solver/step_agreement.hpp"

namespace weavefront::solver {

template <class Visit>
void StepAgreement::visit(Visit visit) {
    for (auto& [force, moment] : on_projectiles) {
        for (auto& component : force) visit(component);
        for (auto& component : moment) visit(component);
    }
    for (auto* count : {&eroded, &left_skin, &adaptation_due, &stop, &checkpoint, &fault}) visit(*count);
    for (auto& energy : sliding_released) visit(energy);
    for (auto& energy : sliding_wanted) visit(energy);
}

void StepAgreement::clear() {
    visit([](std::int64_t& integer) { integer = 0; });
}

void StepAgreement::sum(const parallel::Communicator& comm) {
    if (comm.size() == 1) return;
    message_.clear();
    visit([&](std::int64_t& integer) { message_.push_back(integer); });
    comm.sum(message_);
    auto next = message_.begin();
    visit([&](std::int64_t& integer) { integer = *next++; });
}

}  // namespace weavefront::solver
